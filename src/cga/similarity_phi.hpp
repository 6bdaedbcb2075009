#pragma once

#include "cga/pose.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <type_traits>

// phi(z) = (exp(z) - 1) / z, on which exp, log and power of similarities rest, stable for all
// z = sigma + i theta with |theta| < 2 pi; and the axis and angle of a rotation.

namespace cga {

// phi of a complex number: phi = N conj(z) / |z|^2 with
//   Re N = expm1(sigma) cos(theta) - 2 sin(theta/2)^2
//   Im N = exp(sigma) sin(theta)
// and 1 + z/2 where z^2/6 is below rounding.
template <class T>
[[nodiscard]] std::complex<T> phi(const std::complex<T> &z) noexcept {
	constexpr T SMALL = std::is_same_v<T, float> ? T(1e-12) : T(1e-16);
	const T sigma = z.real();
	const T theta = z.imag();
	const T squared = sigma * sigma + theta * theta;
	if (squared < SMALL) {
		return { T(1) + sigma / T(2), theta / T(2) };
	}
	const T half_sine = std::sin(theta / T(2));
	const T real = std::expm1(sigma) * std::cos(theta) - T(2) * half_sine * half_sine;
	const T imaginary = std::exp(sigma) * std::sin(theta);
	return { (real * sigma + imaginary * theta) / squared, (imaginary * sigma - real * theta) / squared };
}

// phi of a real number.
template <class T>
[[nodiscard]] T phi(T sigma) noexcept {
	return sigma == T(0) ? T(1) : std::expm1(sigma) / sigma;
}

// (exp(alpha z) - 1) / (exp(z) - 1) = alpha phi(alpha z) / phi(z); alpha where z = 0.
template <class Number, class T>
[[nodiscard]] Number power_ratio(const Number &z, T alpha) noexcept {
	return alpha * phi(alpha * z) / phi(z);
}

namespace detail {

// Length without overflow or underflow of the squares, and for float with one rounding.
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
	Vector3<T> axis{ T(0) }; // unit, or zero where the angle is
	T angle = T(0); // radians
};

// The shorter of the two ways that q and -q describe, 0..pi; exact near both ends.
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
