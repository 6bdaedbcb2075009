#pragma once

#include "cga/algebra/algebra_error.hpp"

namespace cga {

// exp(exponent log(M)) if M has a logarithm (logarithm.hpp): principal branch, along the shorter rotation, of weight
// |M|^exponent. power(M, a) power(M, b) = power(M, a + b). power(M, 1) is M or -M: the one whose scalar part is not
// negative.
//
// Versors without a logarithm (odd ones, even ones with M M~ < 0) have only integer powers, which are products: M M M,
// M^-1 M^-1; other exponents are an error. An error for elements that are not versors or not finite, and if the result leaves
// the range of double.
MultivectorResult power(const Multivector &versor, double exponent);

// power(M, 1/2), which is normalized(1 + M) for unit M with a scalar part that is not negative. The square of the
// result is M or -M. The same errors.
MultivectorResult sqrt(const Multivector &versor);

} // namespace cga
