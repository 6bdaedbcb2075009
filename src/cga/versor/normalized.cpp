#include "cga/versor/normalized.hpp"

#include "cga/motor/motor_multivector.hpp"

#include <cmath>
#include <limits>

namespace cga {

namespace {

// Below this fraction of the sum of squares, X X~ and its parts are rounding.
constexpr double ROUNDING = 16.0 * std::numeric_limits<double>::epsilon();

// With X X~ = a + b of grades 0 and 4, a > 0, and n = sqrt(a^2 - b^2):
//   X' = (n + a - b) X / (n sqrt(2 (a + n)))
// from the left. Empty unless n is a positive number.
std::optional<Multivector> nearest_versor(const Multivector &x, double a, const Multivector &b) {
	const double b_squared = b.scalar_product(b);
	const double n_squared = a * a - b_squared;
	if (!(n_squared > ROUNDING * (a * a + std::abs(b_squared)))) {
		return std::nullopt;
	}
	const double n = std::sqrt(n_squared);
	return (Multivector::scalar(n + a) - b).geometric_product(x) * (1.0 / (n * std::sqrt(2.0 * (a + n))));
}

} // namespace

MultivectorResult normalized(const Multivector &x) {
	if (!x.is_finite()) {
		return AlgebraError::NOT_FINITE;
	}
	if (!(x.max_abs() > 0.0)) {
		return AlgebraError::ZERO_HAS_NO_NORM;
	}
	// At unit size, squares neither overflow nor underflow.
	const Multivector unit = x.times_power_of_two(-std::ilogb(x.max_abs()));
	const Multivector square = unit.geometric_product(unit.reverse());
	const double weight = square[0];
	const double rounding = ROUNDING * unit.sum_of_squares();
	if (std::abs(weight) <= rounding) {
		// The coefficients of a motor with a large translation cancel: the minimal form gives its weight.
		const std::optional<Motor<double>> motor = to_motor(unit);
		const double motor_weight = motor ? motor->norm_squared() : 0.0;
		if (!(motor_weight > std::numeric_limits<double>::min())) {
			return AlgebraError::NULL_HAS_NO_NORM;
		}
		return unit * (1.0 / std::sqrt(motor_weight));
	}
	const double sign = weight < 0.0 ? -1.0 : 1.0;
	const bool of_one_parity = unit.is_even(0.0) || unit.is_odd(0.0);
	if (of_one_parity && square.grade(4).max_abs() > rounding) {
		if (const std::optional<Multivector> versor = nearest_versor(unit, sign * weight, square.grade(4) * sign)) {
			return *versor;
		}
	}
	return unit * (1.0 / std::sqrt(std::abs(weight)));
}

} // namespace cga
