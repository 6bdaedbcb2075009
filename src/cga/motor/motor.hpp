#pragma once

#include "cga/motor/pose.hpp"

#include <cmath>
#include <optional>

namespace cga {

// A motor T R D (translator, rotor, dilator) of Cl(4,1) in its minimal form: 12 coefficients in the null basis,
// three quaternions. Of the 16 even coefficients m of a motor, m_i4 = m_i5 and m_1234 = m_1235, so that with
//
//   A_0 = m + m_45    A_12 = m_12 + m_1245    A_13 = m_13 + m_1345    A_23 = m_23 + m_2345
//   B   = the same with minus
//   V_1 = m_14        V_2  = m_24             V_3  = m_34             V_123 = m_1234
//
// A, B and V determine the motor. Packed as quaternions (w, x, y, z):
//
//   a = (A_0, -A_23, A_13, -A_12)     b = (B_0, -B_23, B_13, -B_12)     v = (V_123, V_1, V_2, V_3)
//
// the motor of the pose x -> t + s q x q* is, up to weight,
//
//   a = q / sqrt(s)     b = q sqrt(s)     v = -(1/2) t a     (t the quaternion (0, t1, t2, t3))
//
// Invariants of a motor: a and b are parallel, Re(v conj(b)) = 0. All nonzero multiples of a motor act the same.
template <class T>
struct Motor {
	Quaternion<T> a{ T(1), T(0), T(0), T(0) };
	Quaternion<T> b{ T(1), T(0), T(0), T(0) };
	Quaternion<T> v{ T(0), T(0), T(0), T(0) };

	// T = 1 - (1/2) t e_inf.
	[[nodiscard]] static Motor translator(const Vector3<T> &offset) noexcept;
	// R = w - z e12 + y e13 - x e23, of a unit quaternion.
	[[nodiscard]] static Motor rotor(const Quaternion<T> &rotation) noexcept;
	// D = cosh(g/2) - sinh(g/2) E, scale = exp(g) > 0, about the origin.
	[[nodiscard]] static Motor dilator(T scale) noexcept;
	// T R D of unit weight; the rotation is of unit length, the scale positive.
	[[nodiscard]] static Motor from_pose(const Pose<T> &pose) noexcept;

	// The pose of a motor of any weight. Empty if the weight is zero (a = 0 or b = 0).
	[[nodiscard]] std::optional<Pose<T>> to_pose() const noexcept;
	// M~: reverses the order of all factors.
	[[nodiscard]] Motor reverse() const noexcept;
	// M^-1 = M~ / (M M~). Empty if the weight is zero.
	[[nodiscard]] std::optional<Motor> inverse() const noexcept;
	// The nearest motor of unit weight; repairs rounding in a, b and v. Empty if the weight is zero or a = -k b.
	[[nodiscard]] std::optional<Motor> normalized() const noexcept;
	// The scalar part of M M~; 1 for unit weight.
	[[nodiscard]] T norm_squared() const noexcept;
	// The image of a point; the weight must not be zero.
	[[nodiscard]] Vector3<T> transform_point(const Vector3<T> &point) const noexcept;
};

// The geometric product: `second` acts first, as in M1 M2 X (M1 M2)^-1.
template <class T>
[[nodiscard]] Motor<T> compose(const Motor<T> &first, const Motor<T> &second) noexcept;

} // namespace cga

#include "cga/motor/motor.inl"
