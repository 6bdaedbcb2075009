#pragma once

#include "cga/algebra/multivector.hpp"

#include <string>

// A multivector as people write it.

namespace cga {

// A sum of its coefficients other than zero, in the order of the basis: "1 + 2 e12 - 0.5 e4"; "0" if there are none.
// With `null_basis` in terms of e1, e2, e3, einf and eo instead of e4 and e5: "2 e12^einf - 0.5 eo + 3 einf^eo".
//
// The expression language (playground/expression/parser.hpp) reads both. From the first it gives back the same coefficients, bit
// for bit but for the sign of zeros, as each number is the shortest that reads back as itself; from the second the
// same to rounding. Coefficients so large (above 1e308) that their sums overflow are written in the first form.
[[nodiscard]] std::string to_text(const Multivector &x, bool null_basis = false);

// The same sum for LaTeX's maths mode: "1 + 2 \mathbf{e}_{12} - 1.5 \times 10^{-7} \mathbf{e}_{3}"; in the null basis
// with \mathbf{e}_\infty and \mathbf{e}_o.
[[nodiscard]] std::string to_latex(const Multivector &x, bool null_basis = false);

} // namespace cga
