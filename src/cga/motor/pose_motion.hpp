#pragma once

#include "cga/motor/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cga {

// The rotation as given if it is of unit length within rounding, else normalised; a zero one is the identity.
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

// What carries one pose to another, in the axes of the world but seen from the first one's position, so that it is
// as precise far from the origin as near it. All modes take the hemisphere rule from here.
struct PoseMotion {
	Quaternion<double> turn; // q_to q_from*, or minus that: w >= 0
	Vector3<double> shift; // t_to - t_from
	double hemisphere; // 1, or -1 where minus q_to is the one nearer to q_from
};

[[nodiscard]] inline PoseMotion motion_between(const Pose<double> &from, const Pose<double> &to) noexcept {
	Quaternion<double> turn = unit_rotation(to.rotation) * glm::conjugate(unit_rotation(from.rotation));
	const double hemisphere = turn.w < 0.0 ? -1.0 : 1.0;
	return { turn * hemisphere, to.translation - from.translation, hemisphere };
}

} // namespace cga
