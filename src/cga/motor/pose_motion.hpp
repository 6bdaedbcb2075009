#pragma once

#include "cga/motor/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cga {

// The rotation itself if its length is 1 within rounding, else normalized; the identity if it is zero.
template <class T>
[[nodiscard]] Quaternion<T> unit_rotation(const Quaternion<T> &rotation) noexcept {
	if (std::abs(glm::dot(rotation, rotation) - T(1)) <= T(8) * std::numeric_limits<T>::epsilon()) {
		return rotation;
	}
	const T largest = std::max({ std::abs(rotation.w), std::abs(rotation.x), std::abs(rotation.y), std::abs(rotation.z) });
	if (!(largest > T(0))) {
		return { T(1), T(0), T(0), T(0) };
	}
	const Quaternion<T> scaled(rotation.w / largest, rotation.x / largest, rotation.y / largest, rotation.z / largest);
	return scaled / std::sqrt(glm::dot(scaled, scaled));
}

template <class T>
[[nodiscard]] Pose<T> with_unit_rotation(const Pose<T> &pose) noexcept {
	return { pose.translation, unit_rotation(pose.rotation), pose.scale };
}

// The motion from one pose to another, in world axes and relative to the first position: its precision does not depend
// on the distance from the origin. All modes apply the hemisphere rule through it.
struct PoseMotion {
	Quaternion<double> rotation; // q_to q_from* or its negative, so that w >= 0
	Vector3<double> displacement; // t_to - t_from
	double hemisphere; // -1 where -q_to is nearer to q_from than q_to, else 1
};

[[nodiscard]] inline PoseMotion motion_between(const Pose<double> &from, const Pose<double> &to) noexcept {
	const Quaternion<double> rotation = unit_rotation(to.rotation) * glm::conjugate(unit_rotation(from.rotation));
	const double hemisphere = rotation.w < 0.0 ? -1.0 : 1.0;
	return { rotation * hemisphere, to.translation - from.translation, hemisphere };
}

} // namespace cga
