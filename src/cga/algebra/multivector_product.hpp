#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/algebra/product_table.hpp"
#include "cga/flatten.hpp"

#include <utility>

// A product of two multivectors, unrolled at compile time from its sign table:
//   result[m] = sum over l of sign[l][m] left[l] right[l ^ m]     (l, m bitmaps)
// Terms that a product leaves out are not in its code: 1,024 in the geometric product, 243 in the outer product and
// in each contraction.

namespace cga {

namespace detail {

template <Product product, size_t result, size_t left>
CGA_FLATTEN void add_term(double &sum, const Multivector &a, const Multivector &b) {
	constexpr int SIGN = SIGN_TABLE<product>[left][result];
	constexpr int LEFT_INDEX = BLADE_INDICES[left];
	constexpr int RIGHT_INDEX = BLADE_INDICES[left ^ result];
	if constexpr (SIGN > 0) {
		sum += a[LEFT_INDEX] * b[RIGHT_INDEX];
	} else if constexpr (SIGN < 0) {
		sum -= a[LEFT_INDEX] * b[RIGHT_INDEX];
	}
}

template <Product product, size_t result, size_t... lefts>
CGA_FLATTEN double sum_terms(const Multivector &a, const Multivector &b, std::index_sequence<lefts...>) {
	double sum = 0.0;
	(add_term<product, result, lefts>(sum, a, b), ...);
	return sum;
}

template <Product product, size_t... results>
CGA_FLATTEN Multivector multiply_unrolled(const Multivector &a, const Multivector &b, std::index_sequence<results...>) {
	Multivector whole;
	((whole[BLADE_INDICES[results]] = sum_terms<product, results>(a, b, std::make_index_sequence<BLADE_COUNT>())), ...);
	return whole;
}

} // namespace detail

template <Product product>
[[nodiscard]] Multivector multiply(const Multivector &left, const Multivector &right) {
	return detail::multiply_unrolled<product>(left, right, std::make_index_sequence<BLADE_COUNT>());
}

} // namespace cga
