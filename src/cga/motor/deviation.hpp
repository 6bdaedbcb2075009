#pragma once

#include "cga/motor/interpolate.hpp"

namespace cga {

// The difference between two poses of a body.
struct Deviation {
	double distance = 0.0; // meters
	double angle = 0.0; // radians, 0..pi
};

// `distance` is the largest distance between the two images of a point of the body, over all points that are `lever_arm` (in
// the body's own units) from its origin. A lever arm of 0 gives the distance of the origins; a negative one counts as 0.
[[nodiscard]] Deviation deviation(const Pose<double> &first, const Pose<double> &second, double lever_arm) noexcept;

// The largest deviation between the paths of two modes over weights 0 to 1, and the first weight at which it occurs.
struct PathDeviation {
	double distance = 0.0;
	double distance_weight = 0.0;
	double angle = 0.0;
	double angle_weight = 0.0;
};

[[nodiscard]] PathDeviation path_deviation(const Pose<double> &from, const Pose<double> &to, Mode first, Mode second, double lever_arm) noexcept;

} // namespace cga
