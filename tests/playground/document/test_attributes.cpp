#include "playground/document/attributes.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace playground;

TEST_CASE("known attributes have defaults, which are not stored") {
	Attributes attributes;
	CHECK(is_set(attributes, "visible"));
	CHECK(is_set(attributes, "label"));
	CHECK(!is_set(attributes, "ipns"));
	CHECK(get_attribute(attributes, "note") == AttributeValue(std::string()));
	CHECK(get_attribute(attributes, "color") == AttributeValue(std::string()));
	CHECK(set_attribute(attributes, "visible", false));
	CHECK(!set_attribute(attributes, "visible", false));
	CHECK(!is_set(attributes, "visible"));
	CHECK(attributes.size() == 1);
	CHECK(set_attribute(attributes, "visible", true));
	CHECK(attributes.empty());
	set_attribute(attributes, "ipns", true);
	CHECK(set_attribute(attributes, "ipns", {}));
	CHECK(attributes.empty());
}

TEST_CASE("any other attribute may be set, to a value of any type") {
	Attributes attributes;
	CHECK(get_attribute(attributes, "interpolation/mode") == AttributeValue());
	CHECK(set_attribute(attributes, "interpolation/mode", std::string("screw")));
	CHECK(set_attribute(attributes, "interpolation/mode", 1.0));
	CHECK(get_attribute(attributes, "interpolation/mode") == AttributeValue(1.0));
	CHECK(!is_set(attributes, "interpolation/mode"));
	CHECK(set_attribute(attributes, "interpolation/mode", {}));
	CHECK(!set_attribute(attributes, "interpolation/mode", {}));
	CHECK(attributes.empty());
}

TEST_CASE("check_attribute refuses invalid keys and values") {
	CHECK(check_attribute("visible", true));
	CHECK(check_attribute("visible", 1.0).error().message == "the attribute 'visible' must be a bool, not a number");
	CHECK(check_attribute("note", false).error().message == "the attribute 'note' must be a string, not a bool");
	CHECK(check_attribute("visible", {}));
	for (const char *color : { "", "#102030", "#a0B0c0d0" }) {
		CHECK(check_attribute("color", std::string(color)));
	}
	for (const char *color : { "red", "#12345", "#1234567", "102030#", "#10203g" }) {
		CHECK(check_attribute("color", std::string(color)).error().message == "the attribute 'color' must have the form #rrggbb or #rrggbbaa");
	}
	CHECK(check_attribute("x", std::numeric_limits<double>::infinity()).error().message == "the attribute 'x' must be finite");
	for (const std::string &key : { std::string(), std::string("a b"), std::string("ä"), std::string(65, 'k') }) {
		CHECK(check_attribute(key, true).error().message == "the key of an attribute must consist of 1 to 64 letters, digits, '_', '-', '.' or '/'");
	}
}
