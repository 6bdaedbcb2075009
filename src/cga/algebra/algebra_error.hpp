#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/result.hpp"

namespace cga {

// Why an operation on multivectors has no result.
enum class AlgebraError {
	NOT_FINITE, // a coefficient or coordinate
	EXPONENT_NOT_FINITE,
	// Versors: inverse, norm, exponential, logarithm, power.
	ZERO_HAS_NO_INVERSE,
	SINGULAR,
	INVERSE_OVERFLOW,
	ZERO_HAS_NO_NORM,
	NULL_HAS_NO_NORM,
	EXPONENTIAL_OVERFLOW,
	ZERO_HAS_NO_LOGARITHM,
	NOT_A_VERSOR,
	ODD_HAS_NO_LOGARITHM,
	NEGATIVE_HAS_NO_LOGARITHM,
	LOGARITHM_OVERFLOW,
	FRACTIONAL_POWER,
	EXPONENT_TOO_LARGE,
	POWER_OVERFLOW,
	// Objects: construction, meet, join, projection, reflection.
	ZERO_DIRECTION,
	RADIUS_NOT_POSITIVE,
	COINCIDENT_POINTS,
	COLLINEAR_POINTS,
	CONCYCLIC_POINTS,
	OBJECT_OVERFLOW,
	FIRST_NOT_A_BLADE,
	SECOND_NOT_A_BLADE,
	SECOND_IS_NULL,
	OBJECTS_TOO_FAR_APART,
	RESULT_OVERFLOW,
};

// What was wrong and what to do, without a final period; callers put "Multivector.inverse: " or the like in front.
[[nodiscard]] const char *describe(AlgebraError error) noexcept;

// A multivector, or why there is none.
using MultivectorResult = Result<Multivector, AlgebraError>;

} // namespace cga
