#pragma once

#include "playground/handles/view_ray.hpp"

// The grid that what is dragged keeps to.

namespace playground::handles {

struct Steps {
	double length = 0.0; // metres, and of scales; 0 for none
	double angle = 0.0; // radians; 0 for none
};

// To a multiple of the step.
[[nodiscard]] double rounded(double value, double step);
[[nodiscard]] Vector rounded(const Vector &vector, double step);
// A unit vector whose angle from the plane of x and z, and around y, are multiples of the step; to four decimals.
[[nodiscard]] Vector rounded_direction(const Vector &direction, double step);

} // namespace playground::handles
