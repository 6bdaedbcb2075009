#include "godot/algebra/multivector.hpp"

#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
#include "cga/versor/power.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

// Functions of one multivector: norms, inverse, exponential, logarithm and powers.

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

Multivector::Handle Multivector::normalized() const {
	return make(cga::normalized(_value), "normalized");
}

Multivector::Handle Multivector::inverse() const {
	return make(cga::inverse(_value), "inverse");
}

Multivector::Handle Multivector::exp() const {
	return make(cga::exp(_value), "exp");
}

Multivector::Handle Multivector::log() const {
	return make(cga::log(_value), "log");
}

Multivector::Handle Multivector::sqrt() const {
	return make(cga::sqrt(_value), "sqrt");
}

Multivector::Handle Multivector::power(double p_exponent) const {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_exponent), Handle(), "Multivector.power: the exponent is not finite.");
	return make(cga::power(_value, p_exponent), "power");
}

} // namespace ga_godot
