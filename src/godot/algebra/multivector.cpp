#include "godot/algebra/multivector.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/versor/is_versor.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>

// The multivector as a resource: its coefficients, comparison, and what kind of element it is.

namespace ga_godot {

using godot::PackedFloat64Array;
using godot::vformat;

// Two multivectors are taken for equal if no coefficient differs by more than this, relative to the larger of the two.
static constexpr double EQUALITY = 1e-9;

Multivector::Handle Multivector::make(const cga::Multivector &p_value) {
	ERR_FAIL_COND_V_MSG(!p_value.is_finite(), Handle(), "Multivector: a coefficient of the result is beyond the range of 64-bit floats; scale the operands down first.");
	Handle result;
	result.instantiate();
	result->_value = p_value;
	return result;
}

void Multivector::set_coefficients(const PackedFloat64Array &p_coefficients) {
	ERR_FAIL_COND_MSG(p_coefficients.size() != cga::BLADE_COUNT, vformat("Multivector: coefficients must be 32 numbers, not %d; their order is 1, e1 .. e5, e12 .. e45, e123 .. e345, e1234 .. e2345, e12345.", p_coefficients.size()));
	cga::Multivector value;
	const double *coefficients = p_coefficients.ptr();
	for (int i = 0; i < cga::BLADE_COUNT; i++) {
		ERR_FAIL_COND_MSG(!std::isfinite(coefficients[i]), vformat("Multivector: coefficient %d is not finite; the multivector stays as it was.", i));
		value[i] = coefficients[i];
	}
	_value = value;
	_revision++;
	emit_changed();
}

PackedFloat64Array Multivector::get_coefficients() const {
	PackedFloat64Array coefficients;
	coefficients.resize(cga::BLADE_COUNT);
	std::copy(_value.coefficients().begin(), _value.coefficients().end(), coefficients.ptrw());
	return coefficients;
}

Multivector::Handle Multivector::make(const cga::MultivectorResult &p_result, const char *p_method) {
	ERR_FAIL_COND_V_MSG(!p_result, Handle(), vformat("Multivector.%s: %s.", p_method, cga::describe(p_result.error())));
	return make(*p_result);
}

bool Multivector::is_equal_approx(const Handle &p_other) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), false, "Multivector.is_equal_approx: the other multivector is null.");
	const double size = std::max({ 1.0, _value.max_abs(), p_other->_value.max_abs() });
	return _value.is_equal_approx(p_other->_value, EQUALITY * size);
}

bool Multivector::is_blade() const {
	return cga::is_blade(_value);
}

bool Multivector::is_versor() const {
	return cga::is_versor(_value);
}

bool Multivector::is_motor() const {
	return cga::is_motor(_value);
}

} // namespace ga_godot
