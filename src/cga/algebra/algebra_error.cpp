#include "cga/algebra/algebra_error.hpp"

namespace cga {

const char *describe(AlgebraError error) noexcept {
	switch (error) {
		case AlgebraError::NOT_FINITE:
			return "a coefficient or coordinate is not finite; pass finite numbers";
		case AlgebraError::EXPONENT_NOT_FINITE:
			return "the exponent is not finite";
		case AlgebraError::ZERO_HAS_NO_INVERSE:
			return "zero has no inverse";
		case AlgebraError::SINGULAR:
			return "the multivector has no inverse: it is null or a zero divisor, or too close to one for double precision";
		case AlgebraError::INVERSE_OVERFLOW:
			return "the inverse is outside the range of double; scale the multivector up first";
		case AlgebraError::ZERO_HAS_NO_NORM:
			return "zero cannot be normalized: no multiple of it has norm 1";
		case AlgebraError::NULL_HAS_NO_NORM:
			return "the multivector is null (its norm is zero), so no multiple of it has norm 1; scale null objects by their meaning: a point to -e_inf . X = 1";
		case AlgebraError::EXPONENTIAL_OVERFLOW:
			return "the exponential is outside the range of double; use smaller coefficients";
		case AlgebraError::ZERO_HAS_NO_LOGARITHM:
			return "zero has no logarithm";
		case AlgebraError::NOT_A_VERSOR:
			return "the multivector is not a versor (a product of non-null vectors), or rounding has erased its norm; normalized() turns a noisy one into a versor";
		case AlgebraError::ODD_HAS_NO_LOGARITHM:
			return "an odd versor (a reflection or inversion) has no logarithm: no continuous motion reaches it";
		case AlgebraError::NEGATIVE_HAS_NO_LOGARITHM:
			return "an even versor with negative M M~ (one real and one imaginary inversion) has no logarithm: no continuous motion reaches it";
		case AlgebraError::LOGARITHM_OVERFLOW:
			return "the coefficients of the versor are too large for its logarithm";
		case AlgebraError::FRACTIONAL_POWER:
			return "an odd versor, or an even one with negative M M~, has integer powers only: no continuous motion reaches it";
		case AlgebraError::EXPONENT_TOO_LARGE:
			return "the exponent of a versor without a logarithm must be within -1e9..1e9";
		case AlgebraError::POWER_OVERFLOW:
			return "the power is outside the range of double; use a smaller exponent or a versor of norm 1";
		case AlgebraError::ZERO_DIRECTION:
			return "the direction or normal is zero; pass a vector of any other length";
		case AlgebraError::RADIUS_NOT_POSITIVE:
			return "the radius must be a finite number above zero";
		case AlgebraError::COINCIDENT_POINTS:
			return "two of the points coincide; pass distinct points";
		case AlgebraError::COLLINEAR_POINTS:
			return "the points are collinear, so they define no single plane; pass the corners of a triangle";
		case AlgebraError::CONCYCLIC_POINTS:
			return "the points lie on one circle or line, so they define no single sphere; pass four that do not";
		case AlgebraError::OBJECT_OVERFLOW:
			return "the object is too large or too far from the origin for double precision; keep lengths below 1e100 m";
		case AlgebraError::FIRST_NOT_A_BLADE:
			return "the first multivector is not a blade (a nonzero outer product of vectors), so it represents no object";
		case AlgebraError::SECOND_NOT_A_BLADE:
			return "the second multivector is not a blade (a nonzero outer product of vectors), so it represents no object";
		case AlgebraError::SECOND_IS_NULL:
			return "the second multivector is null (a point, a tangent or a direction), so it has no inverse to project or reflect with";
		case AlgebraError::OBJECTS_TOO_FAR_APART:
			return "the objects are too far apart or too different in size for double precision; move them closer together";
		case AlgebraError::RESULT_OVERFLOW:
			return "the result is too large or too far from the origin for double precision; move the objects closer to the origin";
	}
	return "";
}

} // namespace cga
