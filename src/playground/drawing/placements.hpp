#pragma once

#include "playground/drawing/figure.hpp"

// Where forms are placed for what `classify` found.

namespace playground::drawing {

// With z along a unit vector; x as near to a world axis as it gets.
[[nodiscard]] Placement across(const Vector &origin, const Vector &normal);
// With x along a unit vector.
[[nodiscard]] Placement along(const Vector &origin, const Vector &direction);
// Of a pair with ends at center -+ radius * direction.
[[nodiscard]] Placement between(const Vector &center, const Vector &direction, double radius);
// Of Form::ring: through the ring's anchor, with y along the normal.
[[nodiscard]] Placement around(const Vector &center, const Vector &normal, double radius);
// Of Form::globe.
[[nodiscard]] Placement globe(const Vector &center, double radius);

} // namespace playground::drawing
