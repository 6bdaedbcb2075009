#pragma once

#include "cga/algebra/multivector.hpp"

#include <complex>
#include <optional>

// Cl(4,1) is isomorphic to the 4 x 4 complex matrices: products of elements are products of matrices, and the pseudoscalar I,
// which commutes with all elements and squares to -1, is the imaginary unit.

namespace cga {

using ComplexMatrix = std::array<std::array<std::complex<double>, 4>, 4>;

[[nodiscard]] ComplexMatrix to_matrix(const Multivector &x);
[[nodiscard]] Multivector from_matrix(const ComplexMatrix &matrix);
// By Gaussian elimination with full pivoting. Empty if a pivot is zero.
[[nodiscard]] std::optional<ComplexMatrix> inverse_matrix(const ComplexMatrix &matrix);

} // namespace cga
