#pragma once

#include "cga/motor/interpolate.hpp"

namespace cga {

// How far two poses are from each other, seen at a body that has them.
struct Deviation {
	double distance = 0.0; // metres
	double angle = 0.0; // radians, 0..pi
};

// `distance` is the largest between where the two poses carry one point of the body that is `lever` from the body's
// origin, in the body's own length: of all points of that sphere the one that fares worst. With lever 0 it is that of the
// origins. A lever below 0 counts as 0.
[[nodiscard]] Deviation deviation(const Pose<double> &first, const Pose<double> &second, double lever) noexcept;

// The largest deviation between the paths of two modes, weights 0 to 1, and at which weight it is; the first of equal ones.
struct PathDeviation {
	double distance = 0.0;
	double distance_weight = 0.0;
	double angle = 0.0;
	double angle_weight = 0.0;
};

[[nodiscard]] PathDeviation path_deviation(const Pose<double> &from, const Pose<double> &to, Mode first, Mode second, double lever) noexcept;

} // namespace cga
