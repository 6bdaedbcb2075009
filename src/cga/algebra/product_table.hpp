#pragma once

#include "cga/algebra/blade.hpp"

// The products of Cl(4,1) as tables, computed at compile time. Each product is the geometric product without some of its
// 32 x 32 terms, so that one sign in {-1, 0, 1} for each pair of basis blades defines it.

namespace cga {

enum class Product {
	GEOMETRIC, // all terms
	OUTER, // grade i + j
	INNER, // grade |i - j|, scalars included
	LEFT_CONTRACTION, // grade j - i
	RIGHT_CONTRACTION, // grade i - j
	COMMUTATOR, // (A B - B A) / 2: the terms of blades that anticommute
	SCALAR, // grade 0
};

// Whether `product` includes the part of grade k of the geometric product of blades of grades i and j.
[[nodiscard]] constexpr bool includes_grade(Product product, int i, int j, int k) {
	switch (product) {
		case Product::GEOMETRIC:
			return true;
		case Product::OUTER:
			return k == i + j;
		case Product::INNER:
			return k == (i > j ? i - j : j - i);
		case Product::LEFT_CONTRACTION:
			return k == j - i;
		case Product::RIGHT_CONTRACTION:
			return k == i - j;
		case Product::COMMUTATOR:
			// Blades with n vectors in common satisfy A B = (-1)^(i j - n) B A, and k = i + j - 2 n.
			return (i * j - (i + j - k) / 2) % 2 != 0;
		case Product::SCALAR:
			return k == 0;
	}
	return false;
}

// For each left bitmap and each bitmap of the *result*, the sign of the term; the right bitmap is left ^ result.
using SignTable = std::array<std::array<int, BLADE_COUNT>, BLADE_COUNT>;

[[nodiscard]] constexpr SignTable make_sign_table(Product product) {
	SignTable table{};
	for (unsigned left = 0; left < BLADE_COUNT; ++left) {
		for (unsigned result = 0; result < BLADE_COUNT; ++result) {
			const unsigned right = left ^ result;
			if (includes_grade(product, grade_of_bitmap(left), grade_of_bitmap(right), grade_of_bitmap(result))) {
				table[left][result] = product_sign(left, right);
			}
		}
	}
	return table;
}

template <Product PRODUCT>
inline constexpr SignTable SIGN_TABLE = make_sign_table(PRODUCT);

} // namespace cga
