#include "playground/document/describe_entry.hpp"

#include "playground/document/document.hpp"

#include <doctest/doctest.h>

using namespace playground;

namespace {

std::string description(const char *text, bool ipns = false) {
	Document document;
	REQUIRE(document.add("x", text));
	REQUIRE(document.set_attribute("x", "ipns", ipns));
	return describe(*document.find("x"));
}

} // namespace

TEST_CASE("describe() gives the value of an entry in one line") {
	CHECK(description("circle(e2, e3, 1.5)") == "circle, radius 1.5, center (0, 1, 0), normal (0, 0, 1)");
	CHECK(description("!sphere(e1, 2)", true) == "dual sphere, radius 2, center (1, 0, 0)");
	CHECK(description("2.5") == "number 2.5");
	CHECK(description("0") == "number 0");
	CHECK(description("e1 ^ e1") == "number 0");
	CHECK(description("translator(1, 2, 3)") == "translator, translation (1, 2, 3)");
	CHECK(description("rotor(e3, deg(90))") == "rotor, 90 degrees about (0, 0, 1)");
	CHECK(description("rotor(e3, deg(-90))") == "rotor, 90 degrees about (0, 0, -1)");
	CHECK(description("dilator(2)") == "dilator, scale 2");
	CHECK(description("motor(e1, rotor(e3, deg(90)), 2)") == "motor, translation (1, 0, 0), 90 degrees about (0, 0, 1), scale 2");
	CHECK(description("1 +") == "error: column 4: expected a number, a name or '(', found the end");
	CHECK(description("e12 + e34").substr(0, 22) == "not a blade (residual ");
}
