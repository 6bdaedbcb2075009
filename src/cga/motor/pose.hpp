#pragma once

#include <glm/ext/quaternion_common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

// A pose is what an engine calls a transform with uniform scale. GLM's vectors and quaternions are the
// currency at the border of src/cga; quaternions are Hamilton's, constructed (w, x, y, z), acting as q v q*.

namespace cga {

template <class T>
using Vector3 = glm::vec<3, T>;

template <class T>
using Quaternion = glm::qua<T>;

// The quaternion (0, x, y, z) of a vector, and the vector of a quaternion.
template <class T>
[[nodiscard]] constexpr Quaternion<T> pure(const Vector3<T> &vector) noexcept {
	return { T(0), vector.x, vector.y, vector.z };
}

template <class T>
[[nodiscard]] constexpr Vector3<T> vector_part(const Quaternion<T> &quaternion) noexcept {
	return { quaternion.x, quaternion.y, quaternion.z };
}

// The similarity x -> translation + scale * (rotation x rotation*): scales, then rotates, then translates.
template <class T>
struct Pose {
	Vector3<T> translation{ T(0) }; // metres
	Quaternion<T> rotation{ T(1), T(0), T(0), T(0) }; // unit; q and -q are the same rotation
	T scale = T(1); // positive
};

template <class To, class From>
[[nodiscard]] Pose<To> pose_cast(const Pose<From> &pose) noexcept {
	return { Vector3<To>(pose.translation), Quaternion<To>(To(pose.rotation.w), To(pose.rotation.x), To(pose.rotation.y), To(pose.rotation.z)), To(pose.scale) };
}

} // namespace cga
