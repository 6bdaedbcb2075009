#include "cga/versor/inverse.hpp"

#include "cga/algebra/complex_matrix.hpp"
#include "cga/motor/motor_multivector.hpp"

#include <cmath>

namespace cga {

namespace {

// The limit of the condition number |X| |X^-1|.
constexpr double MAX_CONDITION = 1e13;

// The inverse of an element whose largest coefficient is about 1. Empty if it is singular.
std::optional<Multivector> inverse_by_matrix(const Multivector &x) {
	const std::optional<ComplexMatrix> matrix = inverse_matrix(to_matrix(x));
	if (!matrix) {
		return std::nullopt;
	}
	const Multivector inverse = from_matrix(*matrix);
	if (!(std::sqrt(x.sum_of_squares()) * std::sqrt(inverse.sum_of_squares()) <= MAX_CONDITION)) {
		return std::nullopt;
	}
	// One Newton step, Y (2 - X Y), removes the error of the elimination.
	return inverse.geometric_product(Multivector::scalar(2.0) - x.geometric_product(inverse));
}

} // namespace

MultivectorResult inverse(const Multivector &x) {
	if (!x.is_finite()) {
		return AlgebraError::NOT_FINITE;
	}
	if (!(x.max_abs() > 0.0)) {
		return AlgebraError::ZERO_HAS_NO_INVERSE;
	}
	// At unit size, squares neither overflow nor underflow.
	const int exponent = std::ilogb(x.max_abs());
	const Multivector scaled = x.times_power_of_two(-exponent);
	std::optional<Multivector> inverse = scaled.inverse_of_versor(0.0);
	if (!inverse) {
		inverse = inverse_by_matrix(scaled);
	}
	if (!inverse) {
		// Motors with a large translation have large coefficients that cancel: only the minimal form separates them from null ones.
		if (const std::optional<Motor<double>> motor = to_motor(scaled)) {
			if (const std::optional<Motor<double>> reverse = motor->inverse()) {
				inverse = to_multivector(*reverse);
			}
		}
	}
	if (!inverse) {
		return AlgebraError::SINGULAR;
	}
	const Multivector result = inverse->times_power_of_two(-exponent);
	if (!result.is_finite()) {
		return AlgebraError::INVERSE_OVERFLOW;
	}
	return result;
}

} // namespace cga
