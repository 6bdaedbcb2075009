#pragma once

#include "cga/motor/motor.hpp"

#include <optional>

namespace cga {

// The logarithm of a scaled motor: the bivector L = -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E).
template <class T>
struct MotorLog {
	Vector3<T> rotation{ T(0) }; // w: axis times angle, radians
	Vector3<T> velocity{ T(0) }; // v: metres
	T dilation = T(0); // sigma: ln of the scale
};

// exp(L) as a pose. Any finite L whose scale and translation stay within the range of T.
template <class T>
[[nodiscard]] Pose<T> exp_to_pose(const MotorLog<T> &log) noexcept;
// The logarithm of the shorter way round, angle 0..pi. Unit rotation and positive scale.
template <class T>
[[nodiscard]] MotorLog<T> log_of_pose(const Pose<T> &pose) noexcept;
// The same of a pose whose ln of the scale is known, which for scales near 1 has more digits than the scale.
template <class T>
[[nodiscard]] MotorLog<T> log_of_similarity(const Vector3<T> &translation, const Quaternion<T> &rotation, T dilation) noexcept;
// pose^exponent = exp(exponent log(pose)), without the detour.
template <class T>
[[nodiscard]] Pose<T> power_of_pose(const Pose<T> &pose, T exponent) noexcept;

// exp(L) as a motor of unit weight.
template <class T>
[[nodiscard]] Motor<T> exp(const MotorLog<T> &log) noexcept;
// Of any weight; M and -M act the same and have the same logarithm. Empty if the weight is zero.
template <class T>
[[nodiscard]] std::optional<MotorLog<T>> log(const Motor<T> &motor) noexcept;
// Of unit weight, of the shorter way round. Empty if the weight is zero.
template <class T>
[[nodiscard]] std::optional<Motor<T>> power(const Motor<T> &motor, T exponent) noexcept;

} // namespace cga

#include "cga/motor/motor_exp.inl"
