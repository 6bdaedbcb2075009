#pragma once

#include "cga/algebra/algebra_error.hpp"

namespace cga {

// `x` with unit norm: the scalar part of X' X'~ is 1 or -1. Keeps the orientation.
//
// - Versors and blades, whose X X~ is a scalar: X / sqrt(|X X~|).
// - Other even elements (noisy motors) and other odd ones become the nearest versor: with X X~ = a + b of grades 0
//   and 4 and n = sqrt(a^2 - b^2), X' = (n + a - b) X / (n sqrt(2 (a + n))); a, b change sign where a < 0.
// - Elements without a nearest versor (a^2 <= b^2, mixed parity): X / norm, which is not a versor.
//
// Fails for null elements (norm zero within rounding: points, e_inf, tangents, directions), zero, and elements that are not
// finite.
MultivectorResult normalized(const Multivector &x);

} // namespace cga
