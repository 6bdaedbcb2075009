#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/algebra/null_basis.hpp"

// Objects by parameters and through points, in OPNS: X holds the points p with point(p) ^ X = 0. (point(p) is in
// versor.hpp.) Lengths in metres; directions and normals of any length but zero, of which only the direction counts.
//
// By parameters they have unit weight; through points they are the outer products of the points: line_through(a, b) =
// a ^ b ^ e_inf, circle_through(a, b, c) = a ^ b ^ c. All are computed from centre and radius, not by multiplying
// points, which far from the origin would lose their digits. An error for what is not finite, for a direction or radius
// of zero, for points that coincide within rounding, and where the coefficients would leave the range of double.

namespace cga {

// point ^ e_inf
MultivectorResult flat_point(const Vector3<double> &position);
// a ^ b; its direction is from a to b.
MultivectorResult point_pair(const Vector3<double> &a, const Vector3<double> &b);

// (e_o + p) ^ d ^ e_inf
MultivectorResult line(const Vector3<double> &position, const Vector3<double> &direction);
MultivectorResult line_through(const Vector3<double> &a, const Vector3<double> &b);

// The normal n turns the circle right-handed.
MultivectorResult circle(const Vector3<double> &center, const Vector3<double> &normal, double radius);
// Three points of a line give the line, the circle of infinite radius, from the first to the farthest of them.
MultivectorResult circle_through(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c);

// All p with n . p = distance; `distance` in metres along the unit normal, also negative.
MultivectorResult plane(const Vector3<double> &normal, double distance);
// The normal is (b - a) x (c - a). Three points of a line are an error.
MultivectorResult plane_through(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c);

MultivectorResult sphere(const Vector3<double> &center, double radius);
// Four points of a plane give the plane, the sphere of infinite radius; four of a circle or a line are an error, as
// many spheres hold them.
MultivectorResult sphere_through(const Vector3<double> &a, const Vector3<double> &b, const Vector3<double> &c, const Vector3<double> &d);

// Rounds whose squared radius is -radius^2: valid elements, such as the meet of spheres that do not touch.
MultivectorResult imaginary_point_pair(const Vector3<double> &center, const Vector3<double> &direction, double radius);
MultivectorResult imaginary_circle(const Vector3<double> &center, const Vector3<double> &normal, double radius);
MultivectorResult imaginary_sphere(const Vector3<double> &center, double radius);

// Rounds of radius zero: a point with a direction, and with a plane through it.
MultivectorResult tangent_along(const Vector3<double> &position, const Vector3<double> &direction);
MultivectorResult tangent_across(const Vector3<double> &position, const Vector3<double> &normal);

// What parallel lines have in common, d ^ e_inf, and what parallel planes have, (n I3) ^ e_inf.
MultivectorResult direction(const Vector3<double> &vector);
MultivectorResult direction_across(const Vector3<double> &normal);

} // namespace cga
