// Classification of any multivector, and the functions of versors: what they return is finite.

#include "multivector.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "cga/object/classify.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
#include "cga/versor/power.hpp"

#include <cmath>

namespace {

using fuzz::require;

bool is_finite(const cga::Vector3<double> &vector) {
	return std::isfinite(vector.x + vector.y + vector.z);
}

void require_valid(const cga::Classification &classification) {
	for (const auto &vector : { classification.center, classification.normal, classification.direction }) {
		require(!vector || is_finite(*vector), "a vector is not finite");
	}
	for (const auto &number : { classification.radius, classification.distance }) {
		require(!number || std::isfinite(*number), "a length is not finite");
	}
	if (classification.points) {
		require(is_finite((*classification.points)[0]) && is_finite((*classification.points)[1]), "a point is not finite");
	}
	require(std::isfinite(classification.residual) || classification.kind == cga::Kind::NONE, "the residual is not finite");
	require(!cga::describe(classification).empty(), "no description");
}

void require_valid(const cga::MultivectorResult &result) {
	require(result ? result->is_finite() : cga::describe(result.error())[0] != '\0', "neither a finite value nor an error");
}

} // namespace

void fuzz::run(Input input) {
	const uint8_t operation = input.byte() % 16; // one for each input, as some take long
	const double exponent = operation == 7 ? input.number() : 0.0;
	const cga::Multivector x = multivector_from(input);
	const cga::Multivector y = operation > 8 ? multivector_from(input, 1) : x;
	switch (operation) {
		case 0:
		case 1:
			return require_valid(cga::classify(x, operation == 1));
		case 2:
			return require_valid(cga::inverse(x));
		case 3:
			return require_valid(cga::normalized(x));
		case 4:
			return require_valid(cga::exp(x));
		case 5:
			return require_valid(cga::log(x));
		case 6:
			return require_valid(cga::sqrt(x));
		case 7:
			return require_valid(cga::power(x, exponent));
		case 8:
			(void)cga::is_versor(x);
			(void)cga::is_motor(x);
			(void)cga::to_motor_log(x);
			return;
		case 9:
			return require_valid(cga::meet(x, y));
		case 10:
			return require_valid(cga::join(x, y));
		case 11:
			return require_valid(cga::project_onto(x, y));
		case 12:
			return require_valid(cga::reject_from(x, y));
		case 13:
			return require_valid(cga::reflect_in(x, y));
		case 14:
			return require_valid(cga::classify(x.dual()));
		default:
			return require_valid(cga::classify(x + y));
	}
}
