#include "playground/document/pasted_text.hpp"

#include <doctest/doctest.h>

using namespace playground;

TEST_CASE("an element of ganja.js becomes an expression; any other text is unchanged") {
	std::string object = " {";
	std::string list = "[";
	for (int index = 31; index >= 0; --index) {
		object += "\"" + std::to_string(index) + "\": " + (index == 5 ? "-1.5" : "0") + (index > 0 ? ", " : "}\n");
	}
	for (int index = 0; index < 32; ++index) {
		list += (index > 0 ? "," : "") + std::string(index == 5 ? "-1.5" : "0");
	}
	CHECK(pasted_expression(object) == list + "]");
	CHECK(pasted_expression("{\"coefficients\": " + list + "]}") == list + "]");
	for (const char *text : { "", " ", "e1 + 2", " [1, 2]", "{", "{\"0\": 1}", "{} + 1" }) {
		CHECK(pasted_expression(text) == text);
	}
}
