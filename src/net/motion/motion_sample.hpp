#pragma once

#include "cga/motor/pose.hpp"

namespace net {

/// The pose of a body at a time in ticks.
struct MotionSample {
	double time = 0.0;
	cga::Pose<double> pose;
};

/// The distance between two poses of a body, in meters: the maximum over its center and the points on its axes at
/// the lever arm (ignoring scale), plus the lever arm times the difference of the scales.
[[nodiscard]] double pose_distance(const cga::Pose<double> &a, const cga::Pose<double> &b, double lever_arm);

} // namespace net
