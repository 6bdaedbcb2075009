#pragma once

#include "cga/motor/axis_angle.hpp"
#include "cga/motor/similarity_phi.hpp"

namespace cga {

// The formulas, with theta = |w|, n = w / theta and lambda = sigma + i theta:
//   s = exp(sigma)
//   q = (cos(theta/2), n sin(theta/2))
//   t = phi(sigma) v_along + Re phi(lambda) v_across + Im phi(lambda) (n x v)
// where v_along = (n . v) n, v_across = v - v_along, phi(z) = (exp(z) - 1) / z.

namespace detail {

// The rotation by an angle of any size and sign.
template <class T>
[[nodiscard]] Quaternion<T> rotation_about(const Vector3<T> &axis, T angle) noexcept {
	const T sine = std::sin(angle / T(2));
	return { std::cos(angle / T(2)), axis.x * sine, axis.y * sine, axis.z * sine };
}

// Multiplies the part of `vector` across the axis by `factor`, as a complex number in that plane, and the part along it by
// `real_factor`. `axis` is of unit length or zero.
template <class T>
[[nodiscard]] Vector3<T> scale_and_turn(const Vector3<T> &axis, const Vector3<T> &vector, const std::complex<T> &factor, T real_factor) noexcept {
	const Vector3<T> parallel = axis * glm::dot(axis, vector);
	return parallel * real_factor + (vector - parallel) * factor.real() + glm::cross(axis, vector) * factor.imag();
}

} // namespace detail

template <class T>
Pose<T> exp_to_pose(const MotorLog<T> &log) noexcept {
	const T angle = detail::length(log.rotation);
	const Vector3<T> axis = angle > T(0) ? log.rotation / angle : Vector3<T>(T(0));
	const Vector3<T> translation = detail::scale_and_turn(axis, log.velocity, phi(std::complex<T>(log.dilation, angle)), phi(log.dilation));
	return { translation, detail::rotation_about(axis, angle), std::exp(log.dilation) };
}

// q flipped to w >= 0; theta = 2 atan2(|q_v|, w), n = q_v / |q_v|, sigma = ln s, v from t by 1 / phi.
template <class T>
MotorLog<T> log_of_similarity(const Vector3<T> &translation, const Quaternion<T> &rotation, T dilation) noexcept {
	const AxisAngle<T> turn = short_axis_angle(rotation);
	const Vector3<T> velocity = detail::scale_and_turn(turn.axis, translation, T(1) / phi(std::complex<T>(dilation, turn.angle)), T(1) / phi(dilation));
	return { turn.axis * turn.angle, velocity, dilation };
}

template <class T>
MotorLog<T> log_of_pose(const Pose<T> &pose) noexcept {
	return log_of_similarity(pose.translation, pose.rotation, std::log(pose.scale));
}

// The factors on t are (exp(alpha z) - 1) / (exp(z) - 1) = alpha phi(alpha z) / phi(z), with lambda across n and
// sigma along it.
template <class T>
Pose<T> power_of_pose(const Pose<T> &pose, T exponent) noexcept {
	const AxisAngle<T> turn = short_axis_angle(pose.rotation);
	const T dilation = std::log(pose.scale);
	const Vector3<T> translation = detail::scale_and_turn(turn.axis, pose.translation,
			power_ratio(std::complex<T>(dilation, turn.angle), exponent), power_ratio(dilation, exponent));
	return { translation, detail::rotation_about(turn.axis, exponent * turn.angle), std::exp(exponent * dilation) };
}

template <class T>
Motor<T> exp(const MotorLog<T> &log) noexcept {
	return Motor<T>::from_pose(exp_to_pose(log));
}

template <class T>
std::optional<MotorLog<T>> log(const Motor<T> &motor) noexcept {
	const std::optional<Pose<T>> pose = motor.to_pose();
	return pose ? std::optional(log_of_pose(*pose)) : std::nullopt;
}

template <class T>
std::optional<Motor<T>> power(const Motor<T> &motor, T exponent) noexcept {
	const std::optional<Pose<T>> pose = motor.to_pose();
	return pose ? std::optional(Motor<T>::from_pose(power_of_pose(*pose, exponent))) : std::nullopt;
}

} // namespace cga
