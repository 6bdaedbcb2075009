#pragma once

#include "cga/motor/pose.hpp"
#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

namespace net {

/// The pose of a body at a time in ticks.
struct MotionSample {
	double time = 0.0;
	cga::Pose<double> pose;
};

/// The distance between two poses of a body, in meters: the maximum over its center, the points on its axes at the lever arm (ignoring
/// scale), and sqrt(2/3) times the lever arm times the angle between them; plus the lever arm times the difference of the scales.
[[nodiscard]] inline double pose_distance(const cga::Pose<double> &a, const cga::Pose<double> &b, double lever_arm) {
	// The rotation tolerance is an angle and does not depend on the body's scale, so the lever arm is not scaled.
	const cga::Vector3<double> offset = a.translation - b.translation;
	const glm::dmat3 difference = glm::mat3_cast(a.rotation) - glm::mat3_cast(b.rotation);
	double max_squared = glm::dot(offset, offset);
	double sum = 0.0; // of the squared differences: 8 sin(angle / 2)^2
	for (int i = 0; i < 3; ++i) {
		sum += glm::dot(difference[i], difference[i]);
		const cga::Vector3<double> point = offset + lever_arm * difference[i];
		max_squared = std::max(max_squared, glm::dot(point, point));
	}
	return std::sqrt(std::max(max_squared, lever_arm * lever_arm * sum / 3.0)) + lever_arm * std::fabs(a.scale - b.scale);
}

/// The pose at `weight` from `a` (0) to `b` (1) in mode SEPARATE. All machines compute the same bits.
[[nodiscard]] inline cga::Pose<double> blended(const cga::Pose<double> &a, const cga::Pose<double> &b, double weight) {
	const cga::Quaternion<double> turn = exp_rotation(log_rotation(glm::conjugate(a.rotation) * b.rotation) * weight);
	return { a.translation + (b.translation - a.translation) * weight, a.rotation * turn, a.scale + (b.scale - a.scale) * weight };
}

} // namespace net
