#include "playground/document/attributes.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace playground;

TEST_CASE("known attributes have defaults, which are not kept") {
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

TEST_CASE("other attributes are open") {
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

TEST_CASE("what an attribute cannot be") {
	CHECK(attribute_error("visible", true).empty());
	CHECK(attribute_error("visible", 1.0) == "the attribute 'visible' is a bool, not a number");
	CHECK(attribute_error("note", false) == "the attribute 'note' is a string, not a bool");
	CHECK(attribute_error("visible", {}).empty());
	for (const char *color : { "", "#102030", "#a0B0c0d0" }) {
		CHECK(attribute_error("color", std::string(color)).empty());
	}
	for (const char *color : { "red", "#12345", "#1234567", "102030#", "#10203g" }) {
		CHECK(attribute_error("color", std::string(color)) == "the attribute 'color' is written as #rrggbb or #rrggbbaa");
	}
	CHECK(attribute_error("x", std::numeric_limits<double>::infinity()) == "the attribute 'x' is not finite");
	for (const std::string &key : { std::string(), std::string("a b"), std::string("ä"), std::string(65, 'k') }) {
		CHECK(attribute_error(key, true) == "the key of an attribute has letters, digits, '_', '-', '.' and '/' only, 1 to 64 of them");
	}
}
