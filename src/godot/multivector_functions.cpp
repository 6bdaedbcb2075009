#include "godot/multivector.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <optional>

// Functions of one multivector: norms and inverse.

namespace ga_godot {

double Multivector::norm() const {
	const double norm = _value.norm();
	ERR_FAIL_COND_V_MSG(!std::isfinite(norm), 0.0, "Multivector.norm: the result is beyond the range of 64-bit floats.");
	return norm;
}

double Multivector::norm_squared() const {
	const double norm_squared = _value.norm_squared();
	ERR_FAIL_COND_V_MSG(!std::isfinite(norm_squared), 0.0, "Multivector.norm_squared: the result is beyond the range of 64-bit floats.");
	return norm_squared;
}

Multivector::Handle Multivector::inverse() const {
	const std::optional<cga::Multivector> inverse = _value.inverse_of_versor();
	ERR_FAIL_COND_V_MSG(!inverse, Handle(), "Multivector.inverse: there is none that this version finds; versors and blades that are not null have one.");
	return make(*inverse);
}

Multivector::Handle Multivector::normalized() const {
	const double length = norm();
	ERR_FAIL_COND_V_MSG(!(length > 0.0), Handle(), "Multivector.normalized: the norm is zero (a null element, like a point), so it cannot become 1.");
	return make(_value * (1.0 / length));
}

} // namespace ga_godot
