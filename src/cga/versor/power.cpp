#include "cga/versor/power.hpp"

#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"

#include <cmath>

namespace cga {

namespace {

// All integers beyond this are even, and a product of so many factors has no correct digits.
constexpr double MAX_WHOLE_EXPONENT = 1e9;

// V^n by repeated squaring, n >= 0.
Multivector whole_power(const Multivector &versor, long exponent) {
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
Result<Multivector> power_by_products(const Multivector &versor, double exponent) {
	if (std::abs(exponent) > MAX_WHOLE_EXPONENT) {
		return Failure{ "A versor without logarithm has whole powers up to 1e9 only" };
	}
	const Result<Multivector> unit = normalized(versor);
	if (!unit) {
		return unit;
	}
	const Result<Multivector> factor = exponent < 0.0 ? inverse(*unit) : unit;
	if (!factor) {
		return factor;
	}
	return whole_power(*factor, std::lround(std::abs(exponent))) * std::pow(versor.norm(), exponent);
}

Result<Multivector> power_without_check(const Multivector &versor, double exponent) {
	const Result<Multivector> logarithm = log(versor);
	if (logarithm) {
		const Multivector multiple = *logarithm * exponent;
		if (!multiple.is_finite()) {
			return Failure{ "The power leaves the range of double: the exponent is too large" };
		}
		return exp(multiple);
	}
	if (!is_versor(versor)) {
		return logarithm;
	}
	if (exponent != std::nearbyint(exponent)) {
		return Failure{ "An odd versor, or an even one with negative M M~, has whole powers only: no continuous motion reaches it" };
	}
	return power_by_products(versor, exponent);
}

} // namespace

Result<Multivector> power(const Multivector &versor, double exponent) {
	if (!std::isfinite(exponent)) {
		return Failure{ "The exponent is not finite" };
	}
	const Result<Multivector> result = power_without_check(versor, exponent);
	if (result && !result->is_finite()) {
		return Failure{ "The power leaves the range of double: use a smaller exponent or a versor of unit weight" };
	}
	return result;
}

Result<Multivector> sqrt(const Multivector &versor) {
	return power(versor, 0.5);
}

} // namespace cga
