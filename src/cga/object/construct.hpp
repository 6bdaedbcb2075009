#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_factors.hpp"

// Objects from parameters and through points, in OPNS: X contains the points p with point(p) ^ X = 0 (null_basis.hpp). Lengths
// in meters; directions and normals of any nonzero length, which is ignored.
//
// Objects from parameters have unit weight; objects through points are the outer products of the points: line_through(a, b) =
// a ^ b ^ e_inf, circle_through(a, b, c) = a ^ b ^ c. All are computed from center and radius, not by multiplying points, which
// would lose digits far from the origin. Errors: input that is not finite, a direction or radius of zero, points that coincide
// within rounding, coefficients beyond the range of double.

namespace cga {

// point ^ e_inf
MultivectorResult flat_point(const Vector3<double> &position);
// a ^ b; its direction is from a to b.
MultivectorResult point_pair(const Vector3<double> &a, const Vector3<double> &b);

// (e_o + p) ^ d ^ e_inf
MultivectorResult line(const Vector3<double> &position, const Vector3<double> &direction);
MultivectorResult line_through(const Vector3<double> &a, const Vector3<double> &b);

// The circle is oriented right-handed about the normal.
MultivectorResult circle(const Vector3<double> &center, const Vector3<double> &normal, double radius);
// Three collinear points give the line, a circle of infinite radius, directed from the first to the farthest of them.
MultivectorResult circle_through(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c);

// All p with n . p = distance; `distance` in meters along the unit normal; it may be negative.
MultivectorResult plane(const Vector3<double> &normal, double distance);
// The normal is (b - a) x (c - a). Collinear points are an error.
MultivectorResult plane_through(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c);

MultivectorResult sphere(const Vector3<double> &center, double radius);
// Four coplanar points give the plane, a sphere of infinite radius. Four points on one circle or line are an error: infinitely
// many spheres contain them.
MultivectorResult sphere_through(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c, const Vector3<double> &d);

// Rounds whose squared radius is -radius^2: valid elements, such as the meet of spheres that do not touch.
MultivectorResult imaginary_point_pair(const Vector3<double> &center, const Vector3<double> &direction, double radius);
MultivectorResult imaginary_circle(const Vector3<double> &center, const Vector3<double> &normal, double radius);
MultivectorResult imaginary_sphere(const Vector3<double> &center, double radius);

// Rounds of radius zero: a point with a direction, and a point with a plane through it.
MultivectorResult tangent_along(const Vector3<double> &position, const Vector3<double> &direction);
MultivectorResult tangent_across(const Vector3<double> &position, const Vector3<double> &normal);

// The meet of parallel lines, d ^ e_inf, and that of parallel planes, (n I3) ^ e_inf.
MultivectorResult direction(const Vector3<double> &vector);
MultivectorResult direction_across(const Vector3<double> &normal);

} // namespace cga
