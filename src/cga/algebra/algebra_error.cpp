#include "cga/algebra/algebra_error.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cga {

namespace {

constexpr std::pair<AlgebraError, const char *> TEXTS[] = {
	{ AlgebraError::NOT_FINITE, "a coefficient or coordinate is not finite; pass finite numbers" },
	{ AlgebraError::EXPONENT_NOT_FINITE, "the exponent is not finite; pass a finite number" },
	{ AlgebraError::ZERO_HAS_NO_INVERSE, "zero has no inverse" },
	{ AlgebraError::SINGULAR, "the multivector has no inverse: it is null or a zero divisor, or too close to one for double precision" },
	{ AlgebraError::INVERSE_OVERFLOW, "the inverse is outside the range of double; scale the multivector up first" },
	{ AlgebraError::ZERO_HAS_NO_NORM, "zero cannot be normalized: no multiple of it has norm 1" },
	{ AlgebraError::NULL_HAS_NO_NORM, "the multivector is null (its norm is zero), so no multiple of it has norm 1; scale null objects by their meaning: a point to -e_inf . X = 1" },
	{ AlgebraError::EXPONENTIAL_OVERFLOW, "the exponential is outside the range of double; use smaller coefficients" },
	{ AlgebraError::ZERO_HAS_NO_LOGARITHM, "zero has no logarithm" },
	{ AlgebraError::NOT_A_VERSOR, "the multivector is not a versor (a product of non-null vectors), or rounding has erased its norm; normalized() turns a noisy one into a versor" },
	{ AlgebraError::ODD_HAS_NO_LOGARITHM, "an odd versor (a reflection or inversion) has no logarithm: no continuous motion reaches it" },
	{ AlgebraError::NEGATIVE_HAS_NO_LOGARITHM, "an even versor with negative M M~ (one real and one imaginary inversion) has no logarithm: no continuous motion reaches it" },
	{ AlgebraError::LOGARITHM_OVERFLOW, "the coefficients of the versor are too large for its logarithm" },
	{ AlgebraError::FRACTIONAL_POWER, "an odd versor, or an even one with negative M M~, has integer powers only: no continuous motion reaches it" },
	{ AlgebraError::EXPONENT_TOO_LARGE, "the exponent of a versor without a logarithm must be within -1e9..1e9" },
	{ AlgebraError::POWER_OVERFLOW, "the power is outside the range of double; use a smaller exponent or a versor of norm 1" },
	{ AlgebraError::ZERO_DIRECTION, "the direction or normal is zero; pass a vector of any other length" },
	{ AlgebraError::RADIUS_NOT_POSITIVE, "the radius must be a finite number above zero" },
	{ AlgebraError::COINCIDENT_POINTS, "two of the points coincide; pass distinct points" },
	{ AlgebraError::COLLINEAR_POINTS, "the points are collinear, so they define no single plane; pass the corners of a triangle" },
	{ AlgebraError::CONCYCLIC_POINTS, "the points lie on one circle or line, so they define no single sphere; pass four that do not" },
	{ AlgebraError::OBJECT_OVERFLOW, "the object is too large or too far from the origin for double precision; keep lengths below 1e100 m" },
	{ AlgebraError::FIRST_NOT_A_BLADE, "the first multivector is not a blade (a nonzero outer product of vectors), so it represents no object" },
	{ AlgebraError::SECOND_NOT_A_BLADE, "the second multivector is not a blade (a nonzero outer product of vectors), so it represents no object" },
	{ AlgebraError::SECOND_IS_NULL, "the second multivector is null (a point, a tangent or a direction), so it has no inverse to project or reflect with" },
	{ AlgebraError::OBJECTS_TOO_FAR_APART, "the objects are too far apart or too different in size for double precision; move them closer together" },
	{ AlgebraError::RESULT_OVERFLOW, "the result is too large or too far from the origin for double precision; move the objects closer to the origin" },
};
static_assert(std::size(TEXTS) == size_t(AlgebraError::RESULT_OVERFLOW) + 1);

} // namespace

const char *describe(AlgebraError error) noexcept {
	return std::find_if(std::begin(TEXTS), std::end(TEXTS), [error](const auto &entry) { return entry.first == error; })->second;
}

} // namespace cga
