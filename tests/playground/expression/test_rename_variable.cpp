#include "playground/expression/expression.hpp"

#include <doctest/doctest.h>

using namespace playground;

TEST_CASE("renaming in a text that does not parse") {
	CHECK(with_variable_renamed("a + ", "a", "bcd") == "bcd + ");
	CHECK(with_variable_renamed(" a a(a) aa 2a ) a(", "a", "b") == " b a(b) aa 2b ) a(");
	CHECK(with_variable_renamed("größe * (größe", "größe", "x") == "x * (x");
	CHECK(with_variable_renamed("a # a", "a", "b") == "b # a");
	CHECK(with_variable_renamed("[a, a", "a", "b") == "[a, a");
	CHECK(with_variable_renamed("", "a", "b") == "");
}
