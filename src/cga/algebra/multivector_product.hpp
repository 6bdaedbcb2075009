#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/algebra/product_table.hpp"
#include "cga/platform/compiler.hpp"

#include <utility>

// A product of two multivectors, unrolled at compile time from its sign table:
//   result[m] = sum over l of sign[l][m] left[l] right[l ^ m]     (l, m bitmaps)
// Terms that a product leaves out are not in its code: 1,024 in the geometric product, 243 in the outer product and
// in each contraction.

namespace cga {

namespace detail {

// The product of coefficients of a left blade and of what makes it the result.
template <size_t result, size_t left>
CGA_ALWAYS_INLINE double term(const Multivector &a, const Multivector &b) {
	constexpr int LEFT_INDEX = BLADE_INDICES[left];
	constexpr int RIGHT_INDEX = BLADE_INDICES[left ^ result];
	return a[LEFT_INDEX] * b[RIGHT_INDEX];
}

template <int sign>
CGA_ALWAYS_INLINE void add_signed(double &sum, double value) {
	if constexpr (sign > 0) {
		sum += value;
	} else {
		sum -= value;
	}
}

// Adds the terms of two left blades that differ in e4 and e5, as a pair. Terms that the product leaves out are not in
// its code.
template <Product product, size_t result, size_t left>
CGA_ALWAYS_INLINE void add_pair(double &sum, const Multivector &a, const Multivector &b) {
	constexpr size_t OTHER = left ^ (E4_BIT | E5_BIT);
	constexpr int SIGN = SIGN_TABLE<product>[left][result];
	constexpr int OTHER_SIGN = SIGN_TABLE<product>[OTHER][result];
	if constexpr (SIGN != 0 && OTHER_SIGN != 0) {
		double pair = term<result, left>(a, b);
		add_signed<SIGN * OTHER_SIGN>(pair, term<result, OTHER>(a, b));
		add_signed<SIGN>(sum, pair);
	} else if constexpr (SIGN != 0) {
		add_signed<SIGN>(sum, term<result, left>(a, b));
	} else if constexpr (OTHER_SIGN != 0) {
		add_signed<OTHER_SIGN>(sum, term<result, OTHER>(a, b));
	}
}

// `lefts` are the blades without e5, one of each pair.
template <Product product, size_t result, size_t... lefts>
CGA_ALWAYS_INLINE double sum_terms(const Multivector &a, const Multivector &b, std::index_sequence<lefts...>) {
	double sum = 0.0;
	(add_pair<product, result, lefts>(sum, a, b), ...);
	return sum;
}

template <Product product, size_t... results>
CGA_ALWAYS_INLINE Multivector multiply_unrolled(const Multivector &a, const Multivector &b, std::index_sequence<results...>) {
	Multivector whole;
	((whole[BLADE_INDICES[results]] = sum_terms<product, results>(a, b, std::make_index_sequence<BLADE_COUNT / 2>())), ...);
	return whole;
}

} // namespace detail

template <Product product>
[[nodiscard]] Multivector multiply(const Multivector &left, const Multivector &right) {
	return detail::multiply_unrolled<product>(left, right, std::make_index_sequence<BLADE_COUNT>());
}

} // namespace cga
