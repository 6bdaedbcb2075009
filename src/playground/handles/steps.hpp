#pragma once

#include "playground/handles/view_ray.hpp"

// Snapping of dragged values.

namespace playground::handles {

struct Steps {
	double length = 0.0; // in meters; also the step of scales; 0 for none
	double angle = 0.0; // radians; 0 for none
};

// Rounds to a multiple of the step; unchanged for step 0.
[[nodiscard]] double rounded(double value, double step);
[[nodiscard]] Vector rounded(const Vector &vector, double step);
// Rounds a unit vector's elevation above the xz plane and azimuth around y to multiples of the step, then its components to
// four decimals. Step 0 leaves the vector unchanged.
[[nodiscard]] Vector rounded_direction(const Vector &direction, double step);

} // namespace playground::handles
