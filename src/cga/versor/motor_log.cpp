#include "cga/versor/motor_log.hpp"

#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_packing.hpp"

#include <algorithm>
#include <cmath>

namespace cga {

namespace {

// Whether the pairs of coefficients that are equal in a motor are equal in `x`, relative to themselves: a small transversion must
// not be mistaken for the rounding of a motor.
bool is_equal_in_pairs(const Multivector &x, double tolerance) {
	double largest = 0.0;
	double residue = 0.0;
	for (const NullPair &pair : MOTOR_NULL_PAIRS) {
		largest = std::max(largest, std::abs(x[pair.with_e4]));
		residue = std::max(residue, std::abs(x[pair.with_e4] - x[pair.with_e5]));
	}
	return residue <= tolerance * largest;
}

} // namespace

// exp(L) = T R D
//   R D = R (cosh(sigma/2) - sinh(sigma/2) E)
//   T R D - R D is the motor of a = b = 0, v = -(1/2) t q exp(-sigma/2)
Multivector motor_exp(const MotorLog<double> &log) {
	const Pose<double> pose = exp_to_pose(log);
	const double half = 0.5 * log.dilation;
	const Multivector rotation_and_scale = rotor(pose.rotation).geometric_product(Multivector::scalar(std::cosh(half)) - e_infinity().outer_product(e_origin()) * std::sinh(half));
	const Quaternion<double> zero(0.0, 0.0, 0.0, 0.0);
	const Motor<double> rest{ zero, zero, pure(pose.translation * -0.5) * (pose.rotation * std::exp(-half)) };
	return rotation_and_scale + to_multivector(rest);
}

// With p = (a + b) / 2 the quaternion of the coefficients of 1, e12, e13, e23 and d = (a - b) / 2 that of the same
// with e45, a = q / sqrt(s) and b = q sqrt(s) up to weight:
//   q = p / |p|
//   sinh(sigma) = (|b|^2 - |a|^2) / (2 |a| |b|) = -2 p . d / (|a| |b|)
std::optional<WeightedMotorLog> motor_log(const Multivector &x, double tolerance) {
	const std::optional<Motor<double>> motor = to_motor(x, tolerance);
	const std::optional<Pose<double>> pose = motor ? motor->to_pose() : std::nullopt;
	if (!pose || !is_equal_in_pairs(x, tolerance)) {
		return std::nullopt;
	}
	const Quaternion<double> p(x[0], -x[E23], x[E13], -x[E12]);
	const double dot_d = x[0] * x[E45] + x[E12] * x[E1245] + x[E13] * x[E1345] + x[E23] * x[E2345];
	const double lengths = std::sqrt(glm::dot(motor->a, motor->a)) * std::sqrt(glm::dot(motor->b, motor->b));
	const Quaternion<double> rotation = p / std::sqrt(glm::dot(p, p));
	return WeightedMotorLog{ log_of_similarity(pose->translation, rotation, std::asinh(-2.0 * dot_d / lengths)), std::sqrt(motor->norm_squared()) };
}

} // namespace cga
