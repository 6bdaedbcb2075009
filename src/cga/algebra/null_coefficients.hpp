#pragma once

#include "cga/algebra/multivector.hpp"

// A multivector's coefficients with e_inf in the place of e4 and e_o in the place of e5:
//   a4 e4 + a5 e5 = (a4 + a5)/2 e_inf + (a5 - a4) e_o,     e4 ^ e5 = e_inf ^ e_o
// and so with any of e1, e2, e3 before them. Index i stands for the blade at i with that exchange made:
// e14 is e1 ^ e_inf, e125 is e12 ^ e_o, e1245 is e12 ^ e_inf ^ e_o.

namespace cga {

// A difference of coefficients above 8e307 may overflow.
[[nodiscard]] Multivector::Coefficients to_null_coefficients(const Multivector &x);
[[nodiscard]] Multivector from_null_coefficients(const Multivector::Coefficients &coefficients);

} // namespace cga
