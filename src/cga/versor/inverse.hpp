#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/algebra/multivector.hpp"

namespace cga {

// X^-1 of any invertible element, X X^-1 = X^-1 X = 1.
//
// Motors of any weight, versors and blades by X~ / (X X~), all others as 4 x 4 complex matrices (complex_matrix.hpp).
// An error where X is not finite, and where it has no inverse: X is taken for singular if |X| |X^-1| > 1e13, with |X|
// the root of the sum of the squared coefficients, whatever the size of X. (An inverse beyond would have no digits.)
MultivectorResult inverse(const Multivector &x);

} // namespace cga
