#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/result.hpp"
#include "cga/vector.hpp"

// Objects by their parameters and through points, OPNS. Those through points are the outer product of the points; those
// by parameters have the orientation of their namesakes through points that go round the normal counterclockwise (for
// spheres: with (b - a, c - a, d - a) right-handed).
//
// Errors: points that coincide, directions of length zero, radii that are not positive, what is not finite.

namespace playground {

using Location = cga::Vector3<double>;
using Shape = cga::Result<cga::Multivector>;

// P ^ e_inf
[[nodiscard]] Shape flat_point(const Location &position);
// A ^ B
[[nodiscard]] Shape point_pair(const Location &a, const Location &b);
// P ^ d ^ e_inf, d of unit length
[[nodiscard]] Shape line(const Location &point, const Location &direction);
// A ^ B ^ e_inf
[[nodiscard]] Shape line_through(const Location &a, const Location &b);
// A ^ B ^ C; of three points on a line the line, as the circle of infinite radius.
[[nodiscard]] Shape circle_through(const Location &a, const Location &b, const Location &c);
// -((C - r^2/2 e_inf) ^ (n + (n . c) e_inf)) I, n of unit length
[[nodiscard]] Shape circle(const Location &center, const Location &normal, double radius);
// A ^ B ^ C ^ e_inf; three points on a line are an error.
[[nodiscard]] Shape plane_through(const Location &a, const Location &b, const Location &c);
// -(n + d e_inf) I, n of unit length
[[nodiscard]] Shape plane(const Location &normal, double distance);
// A ^ B ^ C ^ D; of four points in a plane the plane, but four on a circle or a line are an error.
[[nodiscard]] Shape sphere_through(const Location &a, const Location &b, const Location &c, const Location &d);
// -(C - r^2/2 e_inf) I
[[nodiscard]] Shape sphere(const Location &center, double radius);

} // namespace playground
