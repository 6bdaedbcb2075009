#include "playground/document/number_digits.hpp"

#include <doctest/doctest.h>

using namespace playground;

TEST_CASE("numbers of at most ten digits are written exactly, all others are rounded") {
	CHECK(number_text(0.0, 1.0) == "0");
	CHECK(number_text(-0.0, 1.0) == "0");
	CHECK(number_text(0.123456789, 1.0) == "0.123456789");
	CHECK(number_text(10000.125, 0.0) == "10000.125");
	CHECK(number_text(double(1.2f), 1.2) == "1.2");
	CHECK(number_text(double(-0.1f), 0.0) == "-0.1");
	CHECK(number_text(1.0 / 3.0, 0.0) == "0.3333333");
	CHECK(number_text(1.0 / 3.0, 1000.0) == "0.333");
	CHECK(number_text(12345678.9012345, 0.0) == "12345680");
	CHECK(number_text(1.23456789012e-9, 1.0) == "0");
	CHECK(number_text(1.23456789012e-9, 0.0) == "1.234568e-09");
	CHECK(number_text(1.23456789012345e+20, 0.0) == "1.234568e+20");
	CHECK(number_text(1.23456789012345e-200, 0.0) == "1.23456789012345e-200");
	CHECK(number_text(1e+300, 0.0) == "1e+300");
}
