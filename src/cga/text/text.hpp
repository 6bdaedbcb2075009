#pragma once

#include "cga/algebra/multivector.hpp"

#include <string>

// Multivectors as text.

namespace cga {

// The sum of the nonzero terms in the order of the basis: "1 + 2 e12 - 0.5 e4"; "0" if there are none. `null_basis` replaces
// e4 and e5 by einf and eo: "2 e12^einf - 0.5 eo + 3 einf^eo".
// The expression language (playground/expression/parser.hpp) reads both: the first as the same coefficients bit for bit, except
// for the sign of zeros, the second within rounding. Coefficients above 1e308, whose sums would overflow, are written without
// the null basis.
[[nodiscard]] std::string to_text(const Multivector &x, bool null_basis = false);

// The same sum in LaTeX math mode: "1 + 2 \mathbf{e}_{12} - 1.5 \times 10^{-7} \mathbf{e}_{3}"; in the null basis
// with \mathbf{e}_\infty and \mathbf{e}_o.
[[nodiscard]] std::string to_latex(const Multivector &x, bool null_basis = false);

} // namespace cga
