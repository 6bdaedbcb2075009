#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/algebra/multivector.hpp"

// What two objects share, span together, and do to each other. Both are OPNS blades of any weight and sign, at any
// distance from the origin; an error says which of them is none. Sizes may differ as much as coefficients can: what a
// circle of a millimetre shares with a sphere of 100 km is right to some roundings of the circle.
//
// What counts as nothing: lengths within rounding of the objects' own centres, radii and coefficients, and below 1e-10 of
// the smaller of two rounds (beside a point, of the other one; of two flats, of their distance from the origin). Overlapping
// by less, spheres touch, as the circle they share has a radius below 1e-5 of the smaller one's.

namespace cga {

// The largest blade in both, the intersection: of a line and a sphere the point pair, real or imaginary; of crossing
// lines the flat point, of parallel ones their direction, of skew ones e_inf, which all lines share; of tangent objects
// the tangent; of an object and one that holds it, the object; a number where they share nothing. Weight and sign say
// nothing.
MultivectorResult meet(const Multivector &a, const Multivector &b);
// The smallest blade that holds both: of two points the pair, of crossing or parallel lines the plane; the pseudoscalar
// where they span everything.
MultivectorResult join(const Multivector &a, const Multivector &b);

// (X . B) B^-1: what of X is in B. An error for null B (points, tangents, directions), which have no inverse.
MultivectorResult project_onto(const Multivector &x, const Multivector &onto);
// (X ^ B) B^-1: what of X is across B. The same error.
MultivectorResult reject_from(const Multivector &x, const Multivector &from);
// X seen in a mirror: a plane, a sphere (which inverts), a line (half a turn about it), a circle, a point pair. With
// the dual M* of the mirror, M* X M*^-1, X with alternating signs where M* is odd, so that a point stays of positive
// weight. The same error.
MultivectorResult reflect_in(const Multivector &x, const Multivector &mirror);

} // namespace cga
