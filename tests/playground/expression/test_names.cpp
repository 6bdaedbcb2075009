#include "playground/expression/names.hpp"

#include "cga/algebra/blade.hpp"

#include <doctest/doctest.h>

using namespace playground;
using cga::Multivector;

TEST_CASE("the constants") {
	for (int index = 1; index < cga::BLADE_COUNT; ++index) {
		CHECK(constant(cga::blade_name(index).view()) == Multivector::basis_blade(index));
	}
	CHECK(constant("e21") == -Multivector::basis_blade(cga::blade_index("e12")));
	CHECK(constant("e54321") == Multivector::basis_blade(31));
	CHECK(constant("eo") == (*Multivector::basis("e5") - *Multivector::basis("e4")) * 0.5);
	CHECK(constant("einf") == *Multivector::basis("e4") + *Multivector::basis("e5"));
	CHECK(constant("ei") == constant("einf"));
	CHECK(constant("E") == Multivector::basis_blade(cga::blade_index("e45")));
	CHECK(constant("I") == Multivector::basis_blade(31));
	CHECK((*constant("pi"))[0] == 3.141592653589793);
	CHECK((*constant("tau"))[0] == 6.283185307179586);
	for (const char *other : { "e", "e6", "e0", "e11", "i", "x", "", "PI", "EO", "e123456" }) {
		CHECK_FALSE(constant(other).has_value());
	}
}

TEST_CASE("check_name accepts valid names and explains why others are invalid") {
	for (const char *name : { "a", "A", "_", "a1", "snake_case", "CamelCase", "x_1", "größe", "δ", "Точка", "点", "sphere", "e", "e_1", "ex", "E1", "i", "j2" }) {
		CAPTURE(name);
		CHECK(check_name(name));
	}
	CHECK(check_name("").error().message == "a name must have at least one character");
	for (const char *name : { "1a", "a b", "a-b", "a.b", " a", "a ", "×", "a∧b", "a\xff", "π²", "\xf0\x9f\x98\x80", "a\xe2\x80\x8b" }) {
		CAPTURE(name);
		CHECK(check_name(name).error().message == "a name may have only letters, digits and underscores, and may not begin with a digit");
	}
	CHECK(check_name("e1").error().message == "'e1' is a constant; choose another name");
	CHECK(check_name("pi").error().message == "'pi' is a constant; choose another name");
	CHECK(check_name("e6").error().message == "'e6' is not a basis blade; use distinct digits 1 to 5 after 'e'");
	CHECK(check_name(std::string(64, 'a')));
	CHECK(check_name(std::string(65, 'a')).error().message == "'" + std::string(65, 'a') + "' is too long; a name may have at most 64 characters");
}

TEST_CASE("closest_name finds the candidate for a misspelled name") {
	const std::vector<std::string_view> names = { "sphere", "circle", "circle_through", "point", "eo", "Radius" };
	CHECK(closest_name("shpere", names) == "sphere");
	CHECK(closest_name("spere", names) == "sphere");
	CHECK(closest_name("spheree", names) == "sphere");
	CHECK(closest_name("sphare", names) == "sphere");
	CHECK(closest_name("circle_trough", names) == "circle_through");
	CHECK(closest_name("radius", names) == "Radius");
	CHECK(closest_name("xyz", names) == "");
	CHECK(closest_name("e0", names) == "eo");
	CHECK(closest_name(std::string(10000, 'a'), names) == "");
	CHECK(closest_name("", names) == "");
}
