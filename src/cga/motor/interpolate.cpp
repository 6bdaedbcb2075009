#include "cga/motor/interpolate.hpp"

#include "cga/motor/motor_exp.hpp"
#include "cga/motor/pose_motion.hpp"

#include <cmath>

namespace cga {

namespace {

double lerp(double from, double to, double weight) {
	return from * (1.0 - weight) + to * weight;
}

// (1 - a) TR_from + a TR_to, extracted by the formulas of to_pose(). With TR_to = M TR_from, M the motion between them,
// this is ((1 - a) + a M) TR_from, and about the position of `from`:
//   A = (1 - a) + a r
//   t = t_from + a ((a + (1 - a) r_w) d + (1 - a) (d x r_v)) / |A|^2     (d the displacement, r = r_w + r_v the rotation)
//   q = A q_from / |A|
// r_w >= 0 makes |A|^2 >= 1/2. The scale is blended separately.
Pose<double> interpolate_linear(const Pose<double> &from, const Pose<double> &to, double weight) {
	const PoseMotion motion = motion_between(from, to);
	const double rest = 1.0 - weight;
	Quaternion<double> blend = motion.rotation * weight;
	blend.w += rest;
	const double squared = glm::dot(blend, blend);
	const Vector3<double> across = glm::cross(motion.displacement, vector_part(motion.rotation));
	return {
		from.translation + (motion.displacement * (weight + rest * motion.rotation.w) + across * rest) * (weight / squared),
		blend * unit_rotation(from.rotation) / std::sqrt(squared),
		lerp(from.scale, to.scale, weight),
	};
}

// M^a TR_from D_from, with M the motion, including the ratio of the scales, about the position of `from`.
Pose<double> interpolate_screw(const Pose<double> &from, const Pose<double> &to, double weight) {
	const bool positive = to.scale > 0.0 && from.scale > 0.0;
	const PoseMotion motion = motion_between(from, to);
	const Pose<double> power = power_of_pose(Pose<double>{ motion.displacement, motion.rotation, positive ? to.scale / from.scale : 1.0 }, weight);
	return {
		from.translation + power.translation,
		power.rotation * unit_rotation(from.rotation),
		positive ? from.scale * power.scale : lerp(from.scale, to.scale, weight),
	};
}

// slerp is the power of the rotation alone.
Pose<double> interpolate_separate(const Pose<double> &from, const Pose<double> &to, double weight) {
	const PoseMotion motion = motion_between(from, to);
	const Pose<double> power = power_of_pose(Pose<double>{ Vector3<double>(0.0), motion.rotation, 1.0 }, weight);
	return {
		from.translation + motion.displacement * weight,
		power.rotation * unit_rotation(from.rotation),
		lerp(from.scale, to.scale, weight),
	};
}

Pose<double> interpolate_inside(const Pose<double> &from, const Pose<double> &to, double weight, Mode mode) {
	switch (mode) {
		case Mode::LINEAR:
			return interpolate_linear(from, to, weight);
		case Mode::SCREW:
			return interpolate_screw(from, to, weight);
		case Mode::SEPARATE:
			return interpolate_separate(from, to, weight);
	}
	return from;
}

} // namespace

template <class T>
Pose<T> interpolate(const Pose<T> &from, const Pose<T> &to, T weight, Mode mode) noexcept {
	const bool extrapolates = mode == Mode::SCREW;
	if (weight == T(0) || (weight < T(0) && !extrapolates)) {
		return with_unit_rotation(from);
	}
	if (weight == T(1) || (weight > T(1) && !extrapolates)) {
		return with_unit_rotation(to);
	}
	const Pose<double> inside = interpolate_inside(pose_cast<double>(from), pose_cast<double>(to), double(weight), mode);
	const Pose<T> pose = pose_cast<T>(inside);
	return is_finite(pose) ? pose : with_unit_rotation(weight < T(0.5) ? from : to);
}

template Pose<float> interpolate(const Pose<float> &, const Pose<float> &, float, Mode) noexcept;
template Pose<double> interpolate(const Pose<double> &, const Pose<double> &, double, Mode) noexcept;

} // namespace cga
