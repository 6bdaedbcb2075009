#pragma once

#include "cga/algebra/algebra_error.hpp"

namespace cga {

// The principal logarithm of an even versor with M M~ > 0: a bivector, plus the scalar ln |M| if the weight
// |M| = sqrt(M M~) is not 1 within rounding (1.4e-14). exp(log(M)) = M, or -M.
//
// - M and -M act the same and have the same logarithm. exp(log(M)) is the one of the two whose scalar part is not negative:
//   all rotations take the shorter direction, by 0..pi. If the scalar part is zero (a rotation by pi), both directions are equally
//   short, and exp(log(M)) = M.
// - Motors by motor_exp.hpp; transversions, products of reflections and inversions, and all other even versors by
//   log(M) = M_2 h(M_0 + M_4), h(c) = arccos(c) / sqrt(1 - c^2), M of unit weight with parts M_k of grade k.
// - The product of rotations by pi in two orthogonal planes (M_4 alone, M_4^2 = 1) is the same for any such pair of planes: the
//   function picks one pair.
//
// Relative precision: 1e-13 for motors of any translation; for other versors about 1e-15 K^2, K being the largest coefficient at
// unit weight, since its rounding limits the precision of the weight. (Inversions in spheres of radius 1 that are 3 m from the
// origin give K of about 600.)
//
// Every such versor has a logarithm. Fails for odd versors and even ones with M M~ < 0, which no continuous motion reaches,
// for elements that are not versors, and for elements that are not finite.
MultivectorResult log(const Multivector &versor);

} // namespace cga
