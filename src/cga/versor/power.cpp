#include "cga/versor/power.hpp"

#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"

#include <cmath>

namespace cga {

namespace {

// The limit of |n| in V^n: the rounding error grows with n. Within the range of a 32-bit long.
constexpr double MAX_INTEGER_EXPONENT = 1e9;

// V^n by repeated squaring, n >= 0.
Multivector integer_power(const Multivector &versor, long exponent) {
	Multivector result = Multivector::scalar(1.0);
	Multivector square = versor;
	for (long rest = exponent; rest > 0; rest >>= 1) {
		if ((rest & 1) != 0) {
			result = result.geometric_product(square);
		}
		if (rest > 1) {
			square = square.geometric_product(square);
		}
	}
	return result;
}

// The power of a versor without a logarithm, from its unit versor and weight.
MultivectorResult power_by_products(const Multivector &versor, double exponent) {
	if (std::abs(exponent) > MAX_INTEGER_EXPONENT) {
		return AlgebraError::EXPONENT_TOO_LARGE;
	}
	const MultivectorResult unit = normalized(versor);
	if (!unit) {
		return unit;
	}
	const MultivectorResult factor = exponent < 0.0 ? inverse(*unit) : unit;
	if (!factor) {
		return factor;
	}
	return integer_power(*factor, std::lround(std::abs(exponent))) * std::pow(versor.norm(), exponent);
}

MultivectorResult unchecked_power(const Multivector &versor, double exponent) {
	const MultivectorResult logarithm = log(versor);
	if (logarithm) {
		const Multivector multiple = *logarithm * exponent;
		if (!multiple.is_finite()) {
			return AlgebraError::POWER_OVERFLOW;
		}
		return exp(multiple);
	}
	if (!is_versor(versor)) {
		return logarithm;
	}
	if (exponent != std::nearbyint(exponent)) {
		return AlgebraError::FRACTIONAL_POWER;
	}
	return power_by_products(versor, exponent);
}

} // namespace

MultivectorResult power(const Multivector &versor, double exponent) {
	if (!std::isfinite(exponent)) {
		return AlgebraError::EXPONENT_NOT_FINITE;
	}
	const MultivectorResult result = unchecked_power(versor, exponent);
	if (result && !result->is_finite()) {
		return AlgebraError::POWER_OVERFLOW;
	}
	return result;
}

MultivectorResult sqrt(const Multivector &versor) {
	return power(versor, 0.5);
}

} // namespace cga
