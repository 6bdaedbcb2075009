#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/algebra/product_table.hpp"
#include "cga/platform/compiler.hpp"

#include <utility>

// A product of two multivectors, unrolled at compile time from its sign table:
//   result[m] = sum over l of sign[l][m] left[l] right[l ^ m]     (l, m bitmaps)
// Terms with sign 0 generate no code: 1,024 remain in the geometric product, 243 in the outer product and each contraction.

namespace cga {

namespace detail {

// left[LEFT] right[LEFT ^ RESULT] (bitmaps): the term of one left blade in the coefficient of RESULT, without its sign.
template <size_t RESULT, size_t LEFT>
CGA_ALWAYS_INLINE double term(const Multivector &a, const Multivector &b) {
	constexpr int LEFT_INDEX = BLADE_INDICES[LEFT];
	constexpr int RIGHT_INDEX = BLADE_INDICES[LEFT ^ RESULT];
	return a[LEFT_INDEX] * b[RIGHT_INDEX];
}

template <int SIGN>
CGA_ALWAYS_INLINE void add_signed(double &sum, double value) {
	if constexpr (SIGN > 0) {
		sum += value;
	} else {
		sum -= value;
	}
}

// Adds the terms of two left blades that differ in e4 and e5, as a pair.
template <Product PRODUCT, size_t RESULT, size_t LEFT>
CGA_ALWAYS_INLINE void add_pair(double &sum, const Multivector &a, const Multivector &b) {
	constexpr size_t OTHER = LEFT ^ (E4_BIT | E5_BIT);
	constexpr int SIGN = SIGN_TABLE<PRODUCT>[LEFT][RESULT];
	constexpr int OTHER_SIGN = SIGN_TABLE<PRODUCT>[OTHER][RESULT];
	if constexpr (SIGN != 0 && OTHER_SIGN != 0) {
		double pair = term<RESULT, LEFT>(a, b);
		add_signed<SIGN * OTHER_SIGN>(pair, term<RESULT, OTHER>(a, b));
		add_signed<SIGN>(sum, pair);
	} else if constexpr (SIGN != 0) {
		add_signed<SIGN>(sum, term<RESULT, LEFT>(a, b));
	} else if constexpr (OTHER_SIGN != 0) {
		add_signed<OTHER_SIGN>(sum, term<RESULT, OTHER>(a, b));
	}
}

// `LEFTS` are the bitmaps without e5: one of each pair.
template <Product PRODUCT, size_t RESULT, size_t... LEFTS>
CGA_ALWAYS_INLINE double sum_terms(const Multivector &a, const Multivector &b, std::index_sequence<LEFTS...>) {
	double sum = 0.0;
	(add_pair<PRODUCT, RESULT, LEFTS>(sum, a, b), ...);
	return sum;
}

template <Product PRODUCT, size_t... RESULTS>
CGA_ALWAYS_INLINE Multivector multiply_unrolled(const Multivector &a, const Multivector &b, std::index_sequence<RESULTS...>) {
	Multivector product;
	((product[BLADE_INDICES[RESULTS]] = sum_terms<PRODUCT, RESULTS>(a, b, std::make_index_sequence<BLADE_COUNT / 2>())), ...);
	return product;
}

} // namespace detail

template <Product PRODUCT>
[[nodiscard]] Multivector multiply(const Multivector &left, const Multivector &right) {
	return detail::multiply_unrolled<PRODUCT>(left, right, std::make_index_sequence<BLADE_COUNT>());
}

} // namespace cga
