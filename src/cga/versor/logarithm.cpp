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

constexpr double HALF_PI = 1.57079632679489661923;
constexpr double LN_2 = 0.693147180559945309417;

// A weight this near to 1 is 1, rounded.
constexpr double WEIGHT_ROUNDING = 64.0 * std::numeric_limits<double>::epsilon();

// To be a motor, within rounding; others go the general way, which knows no tolerance.
constexpr double MOTOR_ROUNDING = 1e-13;

// ln(weight 2^exponent)
double log_of_weight(double weight, int exponent) {
	const double whole = std::ldexp(weight, exponent);
	return std::abs(whole - 1.0) <= WEIGHT_ROUNDING ? 0.0 : std::log(weight) + exponent * LN_2;
}

// The part of e_k across the vector m, m^2 = -1.
Multivector across(int k, const Multivector &m) {
	const Multivector vector = Multivector::basis_blade(k);
	return vector + m * vector.scalar_product(m);
}

// Of J of grade 4, J^2 = 1, the product of the half turns in any two planes b1, b2 with b1 b2 = J: (pi/2) (b1 + b2),
// with the plane that J's space and e12 have about in common. All of it is across the vector J I^-1.
Multivector log_of_double_half_turn(const Multivector &j) {
	const Multivector m = j.dual();
	Multivector plane = across(blade_index("e1"), m).outer_product(across(blade_index("e2"), m));
	plane *= 1.0 / plane.norm();
	return (plane - plane.geometric_product(j).grade(2)) * HALF_PI;
}

// log(M) = M_2 h(M_0 + M_4) of unit weight and M_0 >= 0.
//
// h is infinite at -1, which M_0 + M_4 is near if M is near a double half turn J = M_4 / |M_4|. M_2 falls apart into
// its halves M_2 (1 +- J) / 2, of the squares -sin(v)^2 and -sin(u)^2 where cos(v), cos(u) = M_0 +- |M_4|; near u = pi
// sin(u) is taken from the half itself.
Multivector log_of_unit_versor(const Multivector &versor) {
	const double number = versor[0];
	const Multivector bivector = versor.grade(2);
	const Multivector four = versor.grade(4);
	const double four_squared = four.scalar_product(four);
	const double length = std::sqrt(std::max(0.0, four_squared));
	if (number - length > -0.5) {
		return arccosine_ratio(number, four_squared).times(bivector, four).grade(2);
	}
	const Multivector j = four * (1.0 / length);
	const Multivector turned = bivector.geometric_product(j).grade(2);
	const Multivector half_v = (bivector + turned) * 0.5;
	const Multivector half_u = (bivector - turned) * 0.5;
	const double sine = std::sqrt(std::max(0.0, -2.0 * half_u.scalar_product(half_u)));
	if (sine <= 16.0 * WEIGHT_ROUNDING * versor.max_abs()) {
		return log_of_double_half_turn(j);
	}
	return half_v * arccosine_ratio(number + length) + half_u * (std::atan2(sine, number - length) / sine);
}

} // namespace

Result<Multivector> log(const Multivector &versor) {
	if (!versor.is_finite()) {
		return Failure{ "The element has a coefficient that is not finite, so it has no logarithm" };
	}
	if (!(versor.max_abs() > 0.0)) {
		return Failure{ "Zero has no logarithm" };
	}
	// At unit size, squares neither overflow nor vanish.
	const int exponent = std::ilogb(versor.max_abs());
	const Multivector scaled = versor.times_power_of_two(-exponent);
	const bool versor_of_some_kind = is_versor(scaled);
	std::optional<WeightedMotorLog> motor = motor_log(scaled, MOTOR_ROUNDING);
	if (!motor && !versor_of_some_kind) {
		return Failure{ "The element is no versor (a product of vectors that are not null), so it has no logarithm here; normalized() makes a versor of a noisy one" };
	}
	if (!motor && scaled.is_odd()) {
		return Failure{ "An odd versor (a reflection, an inversion) has no logarithm: no continuous motion reaches it" };
	}
	if (motor) {
		Multivector result = to_multivector(motor->log);
		result[0] = log_of_weight(motor->weight, exponent);
		return result;
	}
	const double weight_squared = scaled.norm_squared();
	if (weight_squared < 0.0) {
		return Failure{ "An even versor with negative M M~ (one real and one imaginary inversion) has no logarithm: no continuous motion reaches it" };
	}
	const Result<Multivector> unit = normalized(scaled);
	if (!unit) {
		return unit;
	}
	Multivector result = log_of_unit_versor((*unit)[0] < 0.0 ? -*unit : *unit);
	if (!result.is_finite()) {
		return Failure{ "The versor's coefficients are too large for its logarithm" };
	}
	result[0] = log_of_weight(std::sqrt(weight_squared), exponent);
	return result;
}

} // namespace cga
