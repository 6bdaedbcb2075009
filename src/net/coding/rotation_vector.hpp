#pragma once

#include "cga/vector.hpp"

#include <cmath>

// Rotation vectors: axis times angle, in radians.

namespace net {

/// Exponential map of a rotation vector of at most about 8 radians. It uses only additions, multiplications and divisions by
/// constants, so that all machines compute the same bits: Taylor series at a quarter of the half angle, and then the
/// double-angle formulas twice.
[[nodiscard]] inline cga::Quaternion<double> exp_rotation(const cga::Vector3<double> &vector) {
	const cga::Vector3<double> quarter = vector * 0.125;
	const double x = quarter.x * quarter.x + quarter.y * quarter.y + quarter.z * quarter.z;
	double scale = 1.0 - x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0 * (1.0 - x / 110.0 * (1.0 - x / 156.0)))));
	double w = 1.0 - x / 2.0 * (1.0 - x / 12.0 * (1.0 - x / 30.0 * (1.0 - x / 56.0 * (1.0 - x / 90.0 * (1.0 - x / 132.0)))));
	for (int i = 0; i < 2; ++i) {
		scale = 2.0 * w * scale;
		w = 2.0 * w * w - 1.0;
	}
	return cga::Quaternion<double>(w, quarter.x * scale, quarter.y * scale, quarter.z * scale);
}

/// Logarithm map of a unit quaternion: its shortest rotation vector. All machines compute the same bits.
[[nodiscard]] inline cga::Vector3<double> log_rotation(const cga::Quaternion<double> &q) {
	double x = q.x * q.x + q.y * q.y + q.z * q.z;
	double multiple = 1.0;
	if (x >= 0.01) {
		// Halve the angle until the series converges.
		const double whole = std::sqrt(x);
		double sine = whole;
		double cosine = std::fabs(q.w);
		while (x >= 0.01) {
			cosine = std::sqrt(0.5 + 0.5 * cosine);
			sine = 0.5 * sine / cosine;
			x = sine * sine;
			multiple *= 2.0;
		}
		multiple *= sine / whole;
	}
	// The series of asin(s) / s in x = s^2: the next term is below 2e-16.
	double factor = multiple * (2.0 + x * (1.0 / 3.0 + x * (3.0 / 20.0 + x * (5.0 / 56.0 + x * (35.0 / 576.0 + x * (63.0 / 1408.0 + x * (231.0 / 6656.0 + x * (143.0 / 5120.0))))))));
	if (q.w < 0.0) {
		factor = -factor;
	}
	return cga::Vector3<double>(q.x * factor, q.y * factor, q.z * factor);
}

/// The rows of the right Jacobian of the exponential map at a rotation vector: I - a [v]x + b [v]x^2 with
/// a = (1 - cos t) / t^2, b = (t - sin t) / t^3 (Sola, Deray, Atchuthan, "A micro Lie theory", 2018, eq. 143). All machines
/// compute the same bits.
inline void right_jacobian(const cga::Vector3<double> &v, double m[9]) {
	const double t2 = glm::dot(v, v);
	double a = 0.5 - t2 / 24.0 + t2 * t2 / 720.0;
	double b = 1.0 / 6.0 - t2 / 120.0 + t2 * t2 / 5040.0;
	if (t2 > 0.25) {
		// 1 - cos t = 2 s^2 and sin t = 2 s c, with the sine s and the cosine c of half the angle.
		const cga::Quaternion<double> half = exp_rotation(v);
		const double t = std::sqrt(t2);
		const double sine = (half.x * v.x + half.y * v.y + half.z * v.z) / t;
		a = 2.0 * sine * sine / t2;
		b = (t - 2.0 * sine * half.w) / (t2 * t);
	}
	m[0] = 1.0 + b * (v.x * v.x - t2);
	m[4] = 1.0 + b * (v.y * v.y - t2);
	m[8] = 1.0 + b * (v.z * v.z - t2);
	m[1] = b * v.x * v.y + a * v.z;
	m[3] = b * v.x * v.y - a * v.z;
	m[2] = b * v.x * v.z - a * v.y;
	m[6] = b * v.x * v.z + a * v.y;
	m[5] = b * v.y * v.z + a * v.x;
	m[7] = b * v.y * v.z - a * v.x;
}

/// Unwraps a rotation vector: of all vectors of the same rotation, returns the one nearest to `previous`, so that a rotation can
/// continue beyond half a turn.
[[nodiscard]] inline cga::Vector3<double> unwrapped(const cga::Vector3<double> &vector, const cga::Vector3<double> &previous) {
	const double angle = glm::length(vector);
	if (angle < 1.0) {
		return vector;
	}
	constexpr double TURN = 6.28318530717958647693;
	const cga::Vector3<double> opposite = vector * (1.0 - TURN / angle);
	const cga::Vector3<double> longer = vector * (1.0 + TURN / angle);
	const auto distance = [&](const cga::Vector3<double> &v) { return glm::dot(v - previous, v - previous); };
	const cga::Vector3<double> &better = distance(opposite) < distance(longer) ? opposite : longer;
	return distance(better) < distance(vector) ? better : vector;
}

} // namespace net
