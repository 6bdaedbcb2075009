#pragma once

#include "cga/algebra/multivector.hpp"

// The coefficients of a multivector in the null basis, which has e_inf in the place of e4 and e_o in the place of e5:
//   a4 e4 + a5 e5 = (a4 + a5)/2 e_inf + (a5 - a4) e_o,     e4 ^ e5 = e_inf ^ e_o
// and likewise multiplied by e1, e2, e3 from the left. Index i stands for the blade at i with e4 and e5 replaced:
// e14 is e1 ^ e_inf, e125 is e12 ^ e_o, e1245 is e12 ^ e_inf ^ e_o.

namespace cga {

namespace detail {

// Applies `change` to each pair of coefficients whose blades differ only in e4 and e5.
template <class Change>
constexpr void for_each_null_pair(Multivector::Coefficients &coefficients, Change change) {
	for (unsigned euclidean = 0; euclidean < E4_BIT; ++euclidean) {
		change(coefficients[BLADE_INDICES[euclidean | E4_BIT]], coefficients[BLADE_INDICES[euclidean | E5_BIT]]);
	}
}

} // namespace detail

// May overflow if coefficients exceed 8e307.
[[nodiscard]] constexpr Multivector::Coefficients to_null_coefficients(const Multivector &x) {
	Multivector::Coefficients coefficients = x.coefficients();
	detail::for_each_null_pair(coefficients, [](double &fourth, double &fifth) {
		const double infinity = 0.5 * fourth + 0.5 * fifth;
		fifth = fifth - fourth;
		fourth = infinity;
	});
	return coefficients;
}

// c_inf e_inf + c_o e_o = (c_inf - c_o/2) e4 + (c_inf + c_o/2) e5
[[nodiscard]] constexpr Multivector from_null_coefficients(const Multivector::Coefficients &coefficients) {
	Multivector::Coefficients result = coefficients;
	detail::for_each_null_pair(result, [](double &infinity, double &origin) {
		const double fourth = infinity - 0.5 * origin;
		origin = infinity + 0.5 * origin;
		infinity = fourth;
	});
	return Multivector(result);
}

} // namespace cga
