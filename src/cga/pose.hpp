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
