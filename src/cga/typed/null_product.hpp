#pragma once

#include "cga/algebra/null_coefficients.hpp"
#include "cga/algebra/product_table.hpp"

// The products of null blades: basis blades with e_inf in the place of e4 and e_o in that of e5, at the same indices
// (null_coefficients.hpp). Made at compile time by writing both factors in e4 and e5, multiplying, and writing the result
// in e_inf and e_o again. The product of two is one null blade or two, each with a sign: e_inf e_o = -1 + E.

namespace cga::typed {

// Left index, right index, index in the result: the sign there, in {-1, 0, 1}.
using NullTable = std::array<std::array<std::array<int8_t, BLADE_COUNT>, BLADE_COUNT>, BLADE_COUNT>;

namespace detail {

[[nodiscard]] constexpr Multivector null_blade(size_t index) {
	Multivector::Coefficients coefficients{};
	coefficients[index] = 1.0;
	return from_null_coefficients(coefficients);
}

[[nodiscard]] constexpr Multivector multiply_once(const Multivector &a, const Multivector &b) {
	Multivector product;
	for (unsigned left = 0; left < BLADE_COUNT; ++left) {
		const double factor = a[BLADE_INDICES[left]];
		for (unsigned right = 0; factor != 0.0 && right < BLADE_COUNT; ++right) {
			product[BLADE_INDICES[left ^ right]] += product_sign(left, right) * factor * b[BLADE_INDICES[right]];
		}
	}
	return product;
}

[[nodiscard]] constexpr NullTable make_null_table() {
	NullTable table{};
	for (size_t left = 0; left < BLADE_COUNT; ++left) {
		for (size_t right = 0; right < BLADE_COUNT; ++right) {
			const Multivector::Coefficients product = to_null_coefficients(multiply_once(null_blade(left), null_blade(right)));
			for (size_t index = 0; index < BLADE_COUNT; ++index) {
				table[left][right][index] = int8_t(product[index]);
			}
		}
	}
	return table;
}

} // namespace detail

inline constexpr NullTable NULL_TABLE = detail::make_null_table();

// The sign of the null blade at `result` in a product of those at `left` and `right`; 0 where it has none.
[[nodiscard]] constexpr int null_sign(Product product, int left, int right, int result) {
	const bool keeps = keeps_grade(product, blade_grade(left), blade_grade(right), blade_grade(result));
	return keeps ? NULL_TABLE[size_t(left)][size_t(right)][size_t(result)] : 0;
}

} // namespace cga::typed
