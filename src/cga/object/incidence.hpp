#pragma once

#include "cga/algebra/algebra_error.hpp"

// Meet, join, projection and reflection of two OPNS blades of any weight and sign, at any distance from the origin; an error
// says which of the two is not a blade. Sizes may differ by any factor: the meet of a circle of 1 mm with a sphere of 100 km is
// correct to a few rounding errors of the circle.
//
// Lengths count as zero within rounding of the objects' centers, radii and coefficients, and below 1e-10 of the radius of the
// smaller round (with a point: of the other round; for two flats: of their distance from the origin). Spheres that overlap by
// less are tangent: the radius of their circle would be below 1e-5 of the smaller one's.

namespace cga {

// The intersection, the largest blade in both: a point pair, real or imaginary, of a line and a sphere; a flat point of crossing
// lines, their direction if they are parallel, e_inf if they are skew; a tangent of tangent objects; the object itself if the
// other one contains it; a scalar if they have nothing in common. Weight and sign have no meaning.
MultivectorResult meet(const Multivector &a, const Multivector &b);
// The smallest blade that contains both: a point pair of two points, a plane of crossing or parallel lines; the pseudoscalar if
// they span the whole space.
MultivectorResult join(const Multivector &a, const Multivector &b);

// (X . B) B^-1, the part of X in B. An error if B is null (a point, tangent or direction) and has no inverse.
MultivectorResult project_onto(const Multivector &x, const Multivector &onto);
// (X ^ B) B^-1, the part of X orthogonal to B. Fails as project_onto() does.
MultivectorResult reject_from(const Multivector &x, const Multivector &from);
// The reflection of X in a plane, line (a rotation by pi about it), circle or point pair, or its inversion in a sphere. With the
// dual M* of the mirror, M* X M*^-1, with the grade involution of X if M* is odd, so that points keep a positive weight. Fails
// as project_onto() does.
MultivectorResult reflect_in(const Multivector &x, const Multivector &mirror);

} // namespace cga
