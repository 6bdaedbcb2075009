#pragma once

#include "cga/motor/pose.hpp"

#include <algorithm>
#include <cmath>

namespace cga {

namespace detail {

// The length, without overflow or underflow of the squares. The float version rounds only once.
[[nodiscard]] inline float length(const Vector3<float> &vector) noexcept {
	const Vector3<double> wide(vector);
	return float(std::sqrt(glm::dot(wide, wide)));
}

[[nodiscard]] inline double length(const Vector3<double> &vector) noexcept {
	const double largest = std::max({ std::abs(vector.x), std::abs(vector.y), std::abs(vector.z) });
	if (!(largest > 0.0)) {
		return 0.0;
	}
	const Vector3<double> scaled = vector / largest;
	return largest * std::sqrt(glm::dot(scaled, scaled));
}

} // namespace detail

// A rotation by `angle` about `axis`.
template <class T>
struct AxisAngle {
	Vector3<T> axis{ T(0) }; // unit; zero if the angle is zero
	T angle = T(0); // radians
};

// The shorter of the two rotations that q and -q describe, angle 0..pi; precise near both ends.
template <class T>
[[nodiscard]] AxisAngle<T> short_axis_angle(const Quaternion<T> &rotation) noexcept {
	const T sign = rotation.w < T(0) ? T(-1) : T(1);
	const Vector3<T> sines = vector_part(rotation) * sign;
	const T sine = detail::length(sines);
	if (!(sine > T(0))) {
		return {};
	}
	return { sines / sine, T(2) * std::atan2(sine, rotation.w * sign) };
}

} // namespace cga
