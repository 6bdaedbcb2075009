#pragma once

#include "cga/algebra/product_table.hpp"

// The products of null blades: basis blades with e_inf in the place of e4 and e_o in that of e5, at the same indices
// (null_coefficients.hpp). The product of two is zero, a signed null blade, or a sum of two: e_inf e_o = -1 + E.

namespace cga::typed {

// table[left][right][result], by blade index: the sign of the blade `result` in the product, -1, 0 or 1.
using NullTable = std::array<std::array<std::array<int, BLADE_COUNT>, BLADE_COUNT>, BLADE_COUNT>;

namespace detail {

// A null blade is a blade of e1, e2, e3 times one of 1, e_inf, e_o, E, which the bits of e4 and e5 number 0..3.
inline constexpr int NULL_SHIFT = 3;
inline constexpr unsigned EUCLIDEAN_BITS = (1u << NULL_SHIFT) - 1u;

// The products of 1, e_inf, e_o, E: left, right, result.
inline constexpr int NULL_PLANE_PRODUCTS[4][4][4] = {
	{ { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } },
	{ { 0, 1, 0, 0 }, { 0, 0, 0, 0 }, { -1, 0, 0, 1 }, { 0, 1, 0, 0 } },
	{ { 0, 0, 1, 0 }, { -1, 0, 0, -1 }, { 0, 0, 0, 0 }, { 0, 0, -1, 0 } },
	{ { 0, 0, 0, 1 }, { 0, -1, 0, 0 }, { 0, 0, 1, 0 }, { 1, 0, 0, 0 } },
};

// (A M)(B N) = (-1)^(|M| |B|) (A B)(M N), with A, B of e1, e2, e3 and M, N of e_inf, e_o.
[[nodiscard]] constexpr NullTable make_null_table() {
	NullTable table{};
	for (unsigned left = 0; left < BLADE_COUNT; ++left) {
		for (unsigned right = 0; right < BLADE_COUNT; ++right) {
			const unsigned a = left & EUCLIDEAN_BITS, b = right & EUCLIDEAN_BITS;
			const unsigned m = left >> NULL_SHIFT, n = right >> NULL_SHIFT;
			const int sign = product_sign(a, b) * ((grade_of_bitmap(m) * grade_of_bitmap(b)) % 2 == 0 ? 1 : -1);
			for (unsigned result = 0; result < 4; ++result) {
				const unsigned bitmap = (a ^ b) | (result << NULL_SHIFT);
				table[BLADE_INDICES[left]][BLADE_INDICES[right]][BLADE_INDICES[bitmap]] = sign * NULL_PLANE_PRODUCTS[m][n][result];
			}
		}
	}
	return table;
}

} // namespace detail

inline constexpr NullTable NULL_TABLE = detail::make_null_table();

// The coefficient of the null blade at `result` in the product of those at `left` and `right`: -1, 0 or 1.
[[nodiscard]] constexpr int null_sign(Product product, int left, int right, int result) {
	const int sign = NULL_TABLE[size_t(left)][size_t(right)][size_t(result)];
	return sign != 0 && includes_grade(product, blade_grade(left), blade_grade(right), blade_grade(result)) ? sign : 0;
}

} // namespace cga::typed
