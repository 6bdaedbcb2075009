#pragma once

#include "cga/motor/motor.hpp"

#include <optional>

namespace cga {

// The logarithm of a scaled motor: the bivector L = -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E).
template <class T>
struct MotorLog {
	Vector3<T> rotation{ T(0) }; // w: axis times angle, radians
	Vector3<T> velocity{ T(0) }; // v: meters
	T dilation = T(0); // sigma: ln of the scale
};

// exp(L) as a pose. Any finite L whose scale and translation stay within the range of T.
template <class T>
[[nodiscard]] Pose<T> exp_to_pose(const MotorLog<T> &log) noexcept;
// The logarithm of the shorter rotation, angle 0..pi. The rotation must be of unit length, the scale positive.
template <class T>
[[nodiscard]] MotorLog<T> log_of_pose(const Pose<T> &pose) noexcept;
// The same for a pose given by ln(scale), which is more precise than the scale near 1.
template <class T>
[[nodiscard]] MotorLog<T> log_of_similarity(const Vector3<T> &translation, const Quaternion<T> &rotation, T dilation) noexcept;
// pose^exponent = exp(exponent log(pose)), computed directly.
template <class T>
[[nodiscard]] Pose<T> power_of_pose(const Pose<T> &pose, T exponent) noexcept;

// exp(L) as a motor of unit weight.
template <class T>
[[nodiscard]] Motor<T> exp(const MotorLog<T> &log) noexcept;
// The logarithm of a motor of any weight; M and -M have the same one. Empty if the weight is zero.
template <class T>
[[nodiscard]] std::optional<MotorLog<T>> log(const Motor<T> &motor) noexcept;
// exp(exponent log(M)): of unit weight, along the shorter rotation. Empty if the weight is zero.
template <class T>
[[nodiscard]] std::optional<Motor<T>> power(const Motor<T> &motor, T exponent) noexcept;

} // namespace cga

#include "cga/motor/motor_exp.inl"
