#pragma once

#include "cga/vector.hpp"

// A pose: what engines call a transform with uniform scale.

namespace cga {

// The similarity x -> translation + scale * (rotation x rotation*): scales, then rotates, then translates.
template <class T>
struct Pose {
	Vector3<T> translation{ T(0) }; // meters
	Quaternion<T> rotation{ T(1), T(0), T(0), T(0) }; // unit; q and -q are the same rotation
	T scale = T(1); // positive
};

template <class To, class From>
[[nodiscard]] Pose<To> pose_cast(const Pose<From> &pose) noexcept {
	return { Vector3<To>(pose.translation), Quaternion<To>(To(pose.rotation.w), To(pose.rotation.x), To(pose.rotation.y), To(pose.rotation.z)), To(pose.scale) };
}

template <class T>
[[nodiscard]] bool is_finite(const Pose<T> &pose) noexcept {
	return is_finite(pose.translation) && is_finite(vector_part(pose.rotation)) && std::isfinite(pose.rotation.w) && std::isfinite(pose.scale);
}

} // namespace cga
