#include "cga/algebra/blade.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace cga;

TEST_CASE("blades are in the order of grade, then of digits") {
	const char *const names[BLADE_COUNT] = {
		"1", "e1", "e2", "e3", "e4", "e5",
		"e12", "e13", "e14", "e15", "e23", "e24", "e25", "e34", "e35", "e45",
		"e123", "e124", "e125", "e134", "e135", "e145", "e234", "e235", "e245", "e345",
		"e1234", "e1235", "e1245", "e1345", "e2345", "e12345"
	};
	for (int index = 0; index < BLADE_COUNT; ++index) {
		CAPTURE(index);
		CHECK(std::string(blade_name(index).view()) == names[index]);
		CHECK(blade_index(names[index]) == index);
		CHECK(blade_grade(index) == (index == 0 ? 0 : int(std::string(names[index]).size()) - 1));
		CHECK(BLADE_INDICES[BLADE_BITMAPS[size_t(index)]] == index);
	}
}

TEST_CASE("vectors square to their signature and anticommute") {
	for (unsigned left = 0; left < DIMENSION; ++left) {
		for (unsigned right = 0; right < DIMENSION; ++right) {
			const int sign = product_sign(1u << left, 1u << right);
			const int turned = product_sign(1u << right, 1u << left);
			if (left == right) {
				CHECK(sign == (left == 4 ? -1 : 1));
			} else {
				CHECK(sign == (left < right ? 1 : -1));
				CHECK(turned == -sign);
			}
		}
	}
}

TEST_CASE("products of blades agree with sorting their vectors one swap at a time") {
	for (unsigned left = 0; left < BLADE_COUNT; ++left) {
		for (unsigned right = 0; right < BLADE_COUNT; ++right) {
			std::string digits;
			for (const unsigned bitmap : { left, right }) {
				for (int vector = 0; vector < DIMENSION; ++vector) {
					if (((bitmap >> vector) & 1u) != 0) {
						digits += char('1' + vector);
					}
				}
			}
			int sign = 1;
			for (bool changed = true; changed;) {
				changed = false;
				for (size_t i = 0; i + 1 < digits.size(); ++i) {
					if (digits[i] > digits[i + 1]) {
						std::swap(digits[i], digits[i + 1]);
						sign = -sign;
						changed = true;
					} else if (digits[i] == digits[i + 1]) {
						sign *= digits[i] == '5' ? -1 : 1;
						digits.erase(i, 2);
						changed = true;
						break;
					}
				}
			}
			const std::string name = digits.empty() ? "1" : "e" + digits;
			REQUIRE(product_sign(left, right) == sign);
			REQUIRE(BLADE_INDICES[left ^ right] == blade_index(name));
		}
	}
}

TEST_CASE("names with digits in any order have a sign; other names are rejected") {
	CHECK(parse_blade("e21")->index == blade_index("e12"));
	CHECK(parse_blade("e21")->sign == -1);
	CHECK(parse_blade("e312")->sign == 1);
	CHECK(parse_blade("e54321")->index == 31);
	CHECK(parse_blade("e54321")->sign == 1);
	for (const char *name : { "", "e", "2", "e0", "e6", "e11", "e123456", "x12", "e1 ", "E12", "12" }) {
		CAPTURE(name);
		CHECK_FALSE(parse_blade(name).has_value());
	}
}
