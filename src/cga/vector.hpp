#pragma once

#include <glm/ext/quaternion_common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cmath>

// src/cga takes and returns GLM's vectors and quaternions. Quaternions follow Hamilton's convention, are constructed as
// (w, x, y, z) and rotate a vector v to q v q*.

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

template <class T>
[[nodiscard]] bool is_finite(const Vector3<T> &vector) noexcept {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

} // namespace cga
