#include "net/motion/motion_sample.hpp"

#include <algorithm>
#include <cmath>

namespace net {

double pose_distance(const cga::Pose<double> &a, const cga::Pose<double> &b, double lever_arm) {
	// The bound of the rotation is an angle, whatever the size: levers are not scaled, and the scales' difference is added.
	const cga::Vector3<double> offset = a.translation - b.translation;
	const glm::dmat3 difference = glm::mat3_cast(a.rotation) - glm::mat3_cast(b.rotation);
	double worst = glm::dot(offset, offset);
	for (int i = 0; i < 3; ++i) {
		const cga::Vector3<double> point = offset + lever_arm * difference[i];
		worst = std::max(worst, glm::dot(point, point));
	}
	return std::sqrt(worst) + lever_arm * std::fabs(a.scale - b.scale);
}

} // namespace net
