#pragma once

#include "playground/drawing/figure.hpp"

// Placements of forms from what cga::classify finds.

namespace playground::drawing {

// With z along the unit vector `normal`, and x as close to the world's x axis as possible (z axis if they are nearly parallel).
[[nodiscard]] Placement across(const Vector &origin, const Vector &normal);
// With x along the unit vector `direction`.
[[nodiscard]] Placement along(const Vector &origin, const Vector &direction);
// Of a point pair at center -+ radius * direction.
[[nodiscard]] Placement between(const Vector &center, const Vector &direction, double radius);
// Of Form::CIRCLE: the origin is the anchor of the circle, y its normal.
[[nodiscard]] Placement around(const Vector &center, const Vector &normal, double radius);
// Of Form::SPHERE: the origin is the anchor of the sphere.
[[nodiscard]] Placement on_sphere(const Vector &center, double radius);

} // namespace playground::drawing
