#include "cga/text/readable.hpp"

#include <doctest/doctest.h>

using namespace cga;

TEST_CASE("readable() writes six significant digits and clears rounding errors") {
	CHECK(readable(1.0 / 3.0) == "0.333333");
	CHECK(readable(-0.0) == "0");
	CHECK(readable(1e20) == "1e+20");
	CHECK(readable(Vector3<double>(1.0, -0.5, 0.0)) == "(1, -0.5, 0)");
	CHECK(readable(Vector3<double>(1.0, 1e-17, -1e-13)) == "(1, 0, 0)");
	CHECK(readable(Vector3<double>(1e-17, 0.0, 0.0)) == "(1e-17, 0, 0)");
	CHECK(readable(Vector3<double>(1e-17, 0.0, 0.0), 2.0) == "(0, 0, 0)");
}
