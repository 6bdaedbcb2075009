#pragma once

#include "cga/motor/pose.hpp"

namespace net {

/// Where a body was at a time, in ticks.
struct MotionSample {
	double time = 0.0;
	cga::Pose<double> pose;
};

/// The largest distance between two poses of a body at its centre and at the points `lever` out on its axes, as if its
/// scale were 1, and what the difference of scales adds at the lever; in metres.
[[nodiscard]] double pose_distance(const cga::Pose<double> &a, const cga::Pose<double> &b, double lever_arm);

} // namespace net
