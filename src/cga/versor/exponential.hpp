#pragma once

#include "cga/algebra/algebra_error.hpp"

namespace cga {

// exp(X) = 1 + X + X^2 / 2 + X^3 / 6 + ...
//
// - Bivectors of motors, L = -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E): by motor_exp.hpp.
// - Any other bivector B, with or without a scalar k: with B^2 = s + W of grades 0 and 4,
//   exp(k + B) = exp(k) (cosh(sqrt(s + W)) + B sinh(sqrt(s + W)) / sqrt(s + W)).
// - Any other element by its series, scaled and squared.
//
// Precision: 1e-14 of the largest coefficient for motors; for other bivectors about 1e-15 K^2, K being the largest coefficient
// (1e-13 for coefficients of the order of 1).
//
// The exponential of a bivector is a versor of unit weight. Fails if X is not finite or exp(X) leaves the range
// of double.
MultivectorResult exp(const Multivector &x);

} // namespace cga
