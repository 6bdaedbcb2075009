#pragma once

#include "cga/algebra/algebra_error.hpp"

namespace cga {

// The inverse X^-1 of any invertible element: X X^-1 = X^-1 X = 1.
//
// Versors (including motors of any weight) and blades by X~ / (X X~), all others as 4 x 4 complex matrices
// (complex_matrix.hpp). An error if X is not finite or has no inverse: X counts as singular if |X| |X^-1| > 1e13, |X| being the
// Euclidean norm of the coefficients. (An inverse beyond that would have no correct digits.)
MultivectorResult inverse(const Multivector &x);

} // namespace cga
