#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/algebra/multivector.hpp"

namespace cga {

// The principal logarithm of an even versor with M M~ > 0: a bivector, with ln |M| as scalar part beside it where the
// weight |M| = sqrt(M M~) is not 1 within rounding (1.4e-14). exp(log(M)) = M, or -M.
//
// - M and -M act the same and have the same logarithm. Of the two, exp(log(M)) is the one whose scalar part is not
//   negative: all rotations turn the short way round, by 0..pi. Where the scalar part is zero (half a turn) both ways
//   are equally short, and exp(log(M)) = M.
// - Motors by motor_exp.hpp; transversions, products of reflections and inversions, and all other even versors by
//   log(M) = M_2 h(M_0 + M_4), h(c) = arccos(c) / sqrt(1 - c^2), M of unit weight with parts M_k of grade k.
// - The product of two half turns in planes across each other (M_4 alone, M_4^2 = 1) is one about any such pair of
//   planes: one is chosen.
//
// Motors to 1e-13 relative, wherever they carry. Other versors to about 1e-15 K^2, with K the largest coefficient at unit
// weight: that is how well K's rounding lets the weight be known. (Spheres of radius 1 around places 3 m from the origin
// make K about 600.)
//
// Every such versor has one. An error for odd versors and for even ones with M M~ < 0, which no continuous motion
// reaches; for what is no versor; for what is not finite.
MultivectorResult log(const Multivector &versor);

} // namespace cga
