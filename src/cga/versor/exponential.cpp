#include "cga/versor/exponential.hpp"

#include "cga/versor/motor_log.hpp"
#include "cga/versor/study_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cga {

namespace {

constexpr double EPSILON = std::numeric_limits<double>::epsilon();

// exp(B) = even + odd B for a bivector B.
struct Parts {
	StudyNumber even;
	StudyNumber odd;
};

// The series of cosh(sqrt(z)) = sum of z^k / (2 k)! and sinh(sqrt(z)) / sqrt(z) = sum of z^k / (2 k + 1)! for
// z = s + W, of size at most 1.
Parts parts_by_series(double s, double w_squared) {
	const StudyNumber z = { s, 1.0 };
	StudyNumber term = { 1.0, 0.0 }; // z^k / (2 k)!
	Parts parts;
	for (int k = 0; k < 12; ++k) {
		parts.even = parts.even + term;
		parts.odd = parts.odd + term * (1.0 / (2 * k + 1));
		term = multiplied(term, z, w_squared) * (1.0 / ((2 * k + 1) * (2 * k + 2)));
	}
	return parts;
}

// cosh(sqrt(x)) and sinh(sqrt(x)) / sqrt(x) of a real x of either sign: the exponential of a simple bivector of
// square x.
struct Simple {
	double cosine;
	double sine_ratio;
};

Simple simple_exp(double x) {
	const double root = std::sqrt(std::abs(x));
	if (root < 1e-8) {
		return { 1.0, 1.0 };
	}
	return x < 0.0 ? Simple{ std::cos(root), std::sin(root) / root } : Simple{ std::cosh(root), std::sinh(root) / root };
}

// B = B1 + B2, commuting simple bivectors with the squares p and q, p + q = s and p q = W^2 / 4: both real in this
// metric. With the Simple of each, c and r:
//   exp(B) = exp(B1) exp(B2) = c_p c_q + p q W / 2 + X B + Y W B
// - p and q far apart: X = (p c_q p - c_p q q) / (p - q), Y = -(p c_q - c_p q) / (2 (p - q)).
// - p and q near each other, which needs both negative (two rotations by about the same angle): with the sum and the
//   difference of the half angles, u and v, X = (sin u / u + sin v / v) / 2 and
//   Y = (sin v / v - sin u / u) / (u^2 - v^2).
Parts parts_of_split(double s, double w_squared) {
	const double difference = std::sqrt(std::max(0.0, s * s - w_squared)); // |p - q|
	const double p = 0.5 * (s + std::copysign(difference, s)); // the larger
	const double q = p == 0.0 ? 0.0 : 0.25 * w_squared / p;
	const Simple of_p = simple_exp(p);
	const Simple of_q = simple_exp(q);
	Parts parts;
	parts.even = { of_p.cosine * of_q.cosine, 0.5 * of_p.sine_ratio * of_q.sine_ratio };
	if (std::abs(p - q) > 0.5 * std::abs(p)) {
		const double rp_cq = of_p.sine_ratio * of_q.cosine;
		const double cp_rq = of_p.cosine * of_q.sine_ratio;
		parts.odd = { (rp_cq * p - cp_rq * q) / (p - q), -0.5 * (rp_cq - cp_rq) / (p - q) };
	} else {
		const double product = 2.0 * std::sqrt(std::max(0.0, p * q));
		const double sinc_u = simple_exp(-(std::abs(p + q) + product)).sine_ratio;
		const double sinc_v = simple_exp(-std::max(0.0, std::abs(p + q) - product)).sine_ratio;
		parts.odd = { 0.5 * (sinc_u + sinc_v), 0.5 * (sinc_v - sinc_u) / product };
	}
	return parts;
}

// With B^2 = s + W and |W| = |W^2|^(1/2).
Multivector exp_of_bivector(const Multivector &bivector) {
	if (const std::optional<MotorLog<double>> log = to_motor_log(bivector, 4.0 * EPSILON)) {
		const Multivector motor = motor_exp(*log);
		if (motor.is_finite()) {
			return motor;
		}
	}
	const Multivector square = bivector.geometric_product(bivector);
	const double s = square[0];
	const Multivector w = square.grade(4);
	const double w_squared = w.scalar_product(w);
	const bool small = std::abs(s) + std::sqrt(std::abs(w_squared)) <= 1.0;
	const Parts parts = small ? parts_by_series(s, w_squared) : parts_of_split(s, w_squared);
	return Multivector::scalar(parts.even.number) + w * parts.even.four + parts.odd.times(bivector, w).grade(2);
}

// The series of x / 2^n, squared n times.
Multivector exp_by_series(const Multivector &x) {
	double sum_of_sizes = 0.0; // bounds the growth of a coefficient by one multiplication
	for (const double coefficient : x.coefficients()) {
		sum_of_sizes += std::abs(coefficient);
	}
	const int halvings = std::max(0, std::ilogb(std::min(sum_of_sizes, std::numeric_limits<double>::max())) + 2);
	const Multivector small = x.times_power_of_two(-halvings);
	Multivector sum = Multivector::scalar(1.0);
	Multivector term = sum;
	for (int k = 1; k <= 16; ++k) {
		term = term.geometric_product(small) * (1.0 / k);
		sum += term;
	}
	for (int halving = 0; halving < halvings; ++halving) {
		sum = sum.geometric_product(sum);
	}
	return sum;
}

} // namespace

MultivectorResult exp(const Multivector &x) {
	if (!x.is_finite()) {
		return AlgebraError::NOT_FINITE;
	}
	// Scalars commute with all elements: exp(k + X) = exp(k) exp(X).
	const double scalar = x[0];
	Multivector rest = x;
	rest[0] = 0.0;
	const Multivector exp_of_rest = rest == rest.grade(2) ? exp_of_bivector(rest) : exp_by_series(rest);
	const Multivector result = scalar == 0.0 ? exp_of_rest : exp_of_rest * std::exp(scalar);
	if (!result.is_finite()) {
		return AlgebraError::EXPONENTIAL_OVERFLOW;
	}
	return result;
}

} // namespace cga
