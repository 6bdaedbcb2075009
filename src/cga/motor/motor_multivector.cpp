#include "cga/motor/motor_multivector.hpp"

#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_packing.hpp"

#include <algorithm>
#include <cmath>

namespace cga {

namespace {

using Four = std::array<double, 4>;

Four unpack(const Quaternion<double> &quaternion) {
	return { quaternion.w, quaternion.x, quaternion.y, quaternion.z };
}

Quaternion<double> pack(const Four &four) {
	return { four[0], four[1], four[2], four[3] };
}

double largest(const Quaternion<double> &quaternion) {
	double result = 0.0;
	for (const double component : unpack(quaternion)) {
		result = std::max(result, std::abs(component));
	}
	return result;
}

} // namespace

Multivector to_multivector(const Motor<double> &motor) {
	const Four a = unpack(motor.a);
	const Four b = unpack(motor.b);
	const Four v = unpack(motor.v);
	Multivector result;
	for (size_t i = 0; i < 4; ++i) {
		result[MOTOR_PAIRS[i].euclidean] = MOTOR_PAIRS[i].sign * 0.5 * (a[i] + b[i]);
		result[MOTOR_PAIRS[i].with_e45] = MOTOR_PAIRS[i].sign * 0.5 * (a[i] - b[i]);
		result[MOTOR_NULL_PAIRS[i].with_e4] = v[i];
		result[MOTOR_NULL_PAIRS[i].with_e5] = v[i];
	}
	return result;
}

Multivector to_multivector(const MotorLog<double> &log) {
	const Multivector rotation = rotor({ 0.0, log.rotation.x, log.rotation.y, log.rotation.z }); // -(w1 e23 - w2 e13 + w3 e12)
	const Multivector velocity = euclidean(log.velocity).geometric_product(e_infinity());
	const Multivector dilation = e_infinity().outer_product(e_origin()) * log.dilation;
	return (rotation - velocity - dilation) * 0.5;
}

std::optional<Motor<double>> to_motor(const Multivector &x, double tolerance) {
	Four a, b, v;
	double null_residue = 0.0;
	for (size_t i = 0; i < 4; ++i) {
		a[i] = MOTOR_PAIRS[i].sign * (x[MOTOR_PAIRS[i].euclidean] + x[MOTOR_PAIRS[i].with_e45]);
		b[i] = MOTOR_PAIRS[i].sign * (x[MOTOR_PAIRS[i].euclidean] - x[MOTOR_PAIRS[i].with_e45]);
		v[i] = 0.5 * (x[MOTOR_NULL_PAIRS[i].with_e4] + x[MOTOR_NULL_PAIRS[i].with_e5]);
		null_residue = std::max(null_residue, std::abs(x[MOTOR_NULL_PAIRS[i].with_e4] - x[MOTOR_NULL_PAIRS[i].with_e5]));
	}
	const Motor<double> motor{ pack(a), pack(b), pack(v) };
	const double size_a = largest(motor.a);
	const double size_b = largest(motor.b);
	const double size_v = largest(motor.v);
	const double size = std::max(size_a, size_b);
	if (!x.is_finite() || !(size_a > 0.0) || !(size_b > 0.0)) {
		return std::nullopt;
	}
	const double odd_residue = (x - x.grade_involution()).max_abs() * 0.5;
	if (odd_residue > tolerance * size || null_residue > tolerance * std::max(size, size_v)) {
		return std::nullopt;
	}

	// M M~ = (a conj(b), b conj(a), v conj(b) + b conj(v)): a positive scalar a . b and no other part.
	const Quaternion<double> product = (motor.a / size_a) * glm::conjugate(motor.b / size_b);
	const double square_residue = largest({ 0.0, product.x, product.y, product.z });
	const double cross_residue = size_v > 0.0 ? std::abs(glm::dot(motor.v / size_v, motor.b / size_b)) : 0.0;
	if (!(product.w > 0.0) || square_residue > tolerance || cross_residue > tolerance) {
		return std::nullopt;
	}
	return motor;
}

std::optional<MotorLog<double>> to_motor_log(const Multivector &bivector, double tolerance) {
	MotorLog<double> log;
	log.rotation = { -2.0 * bivector[E23], 2.0 * bivector[E13], -2.0 * bivector[E12] };
	log.dilation = -2.0 * bivector[E45];
	double velocity_residue = 0.0;
	double velocity = 0.0;
	for (int axis = 0; axis < 3; ++axis) {
		const double with_e4 = bivector[MOTOR_NULL_PAIRS[axis + 1].with_e4];
		const double with_e5 = bivector[MOTOR_NULL_PAIRS[axis + 1].with_e5];
		log.velocity[axis] = -(with_e4 + with_e5);
		velocity = std::max(velocity, std::abs(with_e4));
		velocity_residue = std::max(velocity_residue, std::abs(with_e4 - with_e5));
	}
	const double other_grades = (bivector - bivector.grade(2)).max_abs();
	if (!bivector.is_finite() || velocity_residue > tolerance * velocity || other_grades > tolerance * bivector.max_abs()) {
		return std::nullopt;
	}
	return log;
}

} // namespace cga
