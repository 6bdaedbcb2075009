#include "net/motion/motion_segment.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

namespace net {

cga::Pose<double> MotionSegment::pose_at(double time) const {
	const double u = std::clamp((time - begin) / length, 0.0, 1.0);
	const double w = u * (1.0 - u);
	cga::Pose<double> pose = start;
	if (scale_ratio != 1.0) {
		pose.scale *= std::exp(u * std::log(scale_ratio));
	}
	if (mode == cga::Mode::SEPARATE) {
		pose.translation += displacement * u + translation_curvature * w;
		pose.rotation = start.rotation * exp_rotation(rotation * u + rotation_curvature * w);
		return pose;
	}
	cga::Pose<double> end = start;
	end.translation += displacement;
	end.rotation = start.rotation * exp_rotation(rotation);
	end.scale *= scale_ratio;
	const double scale = pose.scale;
	pose = cga::interpolate(start, end, u, mode);
	pose.translation += translation_curvature * w;
	pose.rotation = pose.rotation * exp_rotation(rotation_curvature * w);
	pose.scale = scale;
	return pose;
}

} // namespace net
