#pragma once

#include "playground/drawing/figure.hpp"

// Placements of forms, computed from the results of cga::classify.

namespace playground::drawing {

// z is the unit vector `normal`; x is as close as possible to the world's x axis, or to its z axis if x is nearly parallel to z.
[[nodiscard]] Placement across(const Vector &origin, const Vector &normal);
// x is the unit vector `direction`.
[[nodiscard]] Placement along(const Vector &origin, const Vector &direction);
// Places Form::POINT_PAIR at center -+ radius * direction.
[[nodiscard]] Placement between(const Vector &center, const Vector &direction, double radius);
// Places Form::CIRCLE: the origin is the anchor of the circle, y its normal.
[[nodiscard]] Placement around(const Vector &center, const Vector &normal, double radius);
// Places Form::SPHERE: the origin is the anchor of the sphere.
[[nodiscard]] Placement on_sphere(const Vector &center, double radius);

} // namespace playground::drawing
