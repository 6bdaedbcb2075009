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
// Rounds the elevation above the xz plane and the azimuth around y of a unit vector to multiples of the step. The result has
// four decimals, unless the step is 0.
[[nodiscard]] Vector rounded_direction(const Vector &direction, double step);

} // namespace playground::handles
