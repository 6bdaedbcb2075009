#include "cga/versor/logarithm.hpp"

#include "cga/versor/arccosine_ratio.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/motor_log.hpp"
#include "cga/versor/normalized.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cga {

namespace {

constexpr double LN_2 = 0.693147180559945309417;

// A weight this close to 1 counts as 1.
constexpr double WEIGHT_ROUNDING = 64.0 * std::numeric_limits<double>::epsilon();

// The tolerance within which a versor counts as a motor; all others take the general path, which has no tolerance.
constexpr double MOTOR_ROUNDING = 1e-13;

// ln(weight 2^exponent)
double log_of_weight(double weight, int exponent) {
	const double whole = std::ldexp(weight, exponent);
	return std::abs(whole - 1.0) <= WEIGHT_ROUNDING ? 0.0 : std::log(weight) + exponent * LN_2;
}

// Three pairwise orthogonal planes in the space of J (grade 4, J^2 = 1).
//
// J's space is orthogonal to the vector J I^-1 = (x, y, z, w, e5's part). The vectors (-y, x, -w, z), (-z, w, x, -y) and
// (-w, -z, y, x) are orthogonal to it and to each other, and have no part of e5: no coefficient is above 1.
std::array<Multivector, 3> planes_of(const Multivector &j) {
	const Multivector normal = j.dual();
	const bool along_e5 = normal == normal[E5] * Multivector::basis_blade(E5);
	const double x = along_e5 ? 1.0 : normal[E1]; // then any three vectors will do
	const double y = normal[E2];
	const double z = normal[E3];
	const double w = normal[E4];
	const double squared = x * x + y * y + z * z + w * w;
	Multivector first;
	first[E1] = -y, first[E2] = x, first[E3] = -w, first[E4] = z;
	Multivector second;
	second[E1] = -z, second[E2] = w, second[E3] = x, second[E4] = -y;
	Multivector third;
	third[E1] = -w, third[E2] = -z, third[E3] = y, third[E4] = x;
	return { first.outer_product(second) * (1.0 / squared), first.outer_product(third) * (1.0 / squared), second.outer_product(third) * (1.0 / squared) };
}

// The logarithm of M near J = M_4 / |M_4|, where h(M_0 + M_4) is near its pole. With K_v, K_u = M_2 (1 +- J) / 2 and
// cos(v), cos(u) = M_0 +- |M_4|, M_2 = K_v + K_u and log(M) = v K_v / sin(v) + u K_u / sin(u).
//
// Since sin(u) is small, K_u is recomposed from the planes F of J's space: K_u = sum of c F (1 - J) / 2, c = -2 <K_u F>,
// sin(u) = |c|. Rounding of c then only rotates the planes of rotation. For c = 0, any plane is valid.
Multivector log_near_double_rotation_by_pi(double number, const Multivector &bivector, const Multivector &four, double length) {
	const Multivector j = four * (1.0 / length);
	const Multivector turned = bivector.geometric_product(j).grade(2);
	const Multivector half_v = (bivector + turned) * 0.5;
	const Multivector half_u = (bivector - turned) * 0.5;
	const std::array<Multivector, 3> planes = planes_of(j);
	Multivector plane;
	double sine_squared = 0.0;
	for (const Multivector &f : planes) {
		const double c = -2.0 * half_u.scalar_product(f);
		plane += f * c;
		sine_squared += c * c;
	}
	const double sine = std::sqrt(sine_squared);
	plane = sine > 0.0 ? plane * (1.0 / sine) : planes[0];
	const Multivector direction = (plane - plane.geometric_product(j).grade(2)) * 0.5;
	return half_v * arccosine_ratio(number + length) + direction * std::atan2(sine, number - length);
}

// log(M) = M_2 h(M_0 + M_4) for unit weight and M_0 >= 0.
Multivector log_of_unit_versor(const Multivector &versor) {
	const double number = versor[0];
	const Multivector bivector = versor.grade(2);
	const Multivector four = versor.grade(4);
	const double four_squared = four.scalar_product(four);
	const double length = std::sqrt(std::max(0.0, four_squared));
	if (number - length < -0.5) {
		return log_near_double_rotation_by_pi(number, bivector, four, length);
	}
	return arccosine_ratio(number, four_squared).times(bivector, four).grade(2);
}

} // namespace

MultivectorResult log(const Multivector &versor) {
	if (!versor.is_finite()) {
		return AlgebraError::NOT_FINITE;
	}
	if (!(versor.max_abs() > 0.0)) {
		return AlgebraError::ZERO_HAS_NO_LOGARITHM;
	}
	// At unit size, squares neither overflow nor underflow.
	const int exponent = std::ilogb(versor.max_abs());
	const Multivector scaled = versor.times_power_of_two(-exponent);
	const bool is_a_versor = is_versor(scaled);
	std::optional<WeightedMotorLog> motor = motor_log(scaled, MOTOR_ROUNDING);
	if (!motor && !is_a_versor) {
		return AlgebraError::NOT_A_VERSOR;
	}
	if (!motor && scaled.is_odd()) {
		return AlgebraError::ODD_HAS_NO_LOGARITHM;
	}
	if (motor) {
		Multivector result = to_multivector(motor->log);
		result[0] = log_of_weight(motor->weight, exponent);
		return result;
	}
	const double weight_squared = scaled.norm_squared();
	if (weight_squared < 0.0) {
		return AlgebraError::NEGATIVE_HAS_NO_LOGARITHM;
	}
	const MultivectorResult unit = normalized(scaled);
	if (!unit) {
		return unit;
	}
	Multivector result = log_of_unit_versor((*unit)[0] < 0.0 ? -*unit : *unit);
	if (!result.is_finite()) {
		return AlgebraError::LOGARITHM_OVERFLOW;
	}
	result[0] = log_of_weight(std::sqrt(weight_squared), exponent);
	return result;
}

} // namespace cga
