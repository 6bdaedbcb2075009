#include "godot/algebra/multivector.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/text/json.hpp"
#include "cga/text/text.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
#include "cga/versor/power.hpp"
#include "godot/algebra/conversions.hpp"
#include "playground/expression/evaluate.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>

// Coefficients, products, functions of one multivector, and conversions to transforms and text.

namespace ga_godot {

using godot::Array;
using godot::Dictionary;
using godot::PackedFloat64Array;
using godot::Quaternion;
using godot::String;
using godot::Transform3D;
using godot::Variant;
using godot::Vector3;
using godot::vformat;

// The largest difference between coefficients that count as equal, relative to the largest coefficient of both multivectors.
static constexpr double EQUALITY_TOLERANCE = 1e-9;

static constexpr const char *NOT_A_MOTOR = "Multivector.%s: this multivector is not a motor with a positive scale, so it has no transform.";

Multivector::Handle Multivector::make(const cga::Multivector &value) {
	ERR_FAIL_COND_V_MSG(!value.is_finite(), Handle(), "Multivector: a coefficient of the result is beyond the range of 64-bit floats; scale the operands down first.");
	Handle result;
	result.instantiate();
	result->_value = value;
	return result;
}

void Multivector::set_coefficients(const PackedFloat64Array &coefficients) {
	ERR_FAIL_COND_MSG(coefficients.size() != cga::BLADE_COUNT, vformat("Multivector: coefficients must have 32 numbers, not %d, in the order 1, e1 .. e5, e12 .. e45, e123 .. e345, e1234 .. e2345, e12345.", coefficients.size()));
	cga::Multivector value;
	const double *values = coefficients.ptr();
	for (int i = 0; i < cga::BLADE_COUNT; i++) {
		ERR_FAIL_COND_MSG(!std::isfinite(values[i]), vformat("Multivector: coefficient %d is not finite; the multivector is unchanged.", i));
		value[i] = values[i];
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

Multivector::Handle Multivector::make(const cga::MultivectorResult &result, const char *method) {
	ERR_FAIL_COND_V_MSG(!result, Handle(), vformat("Multivector.%s: %s.", method, cga::describe(result.error())));
	return make(*result);
}

bool Multivector::is_equal_approx(const Handle &other) const {
	ERR_FAIL_COND_V_MSG(other.is_null(), false, "Multivector.is_equal_approx: the other multivector is null.");
	const double size = std::max({ 1.0, _value.max_abs(), other->_value.max_abs() });
	return _value.is_equal_approx(other->_value, EQUALITY_TOLERANCE * size);
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

Multivector::Handle Multivector::binary(BinaryOperation operation, const Handle &right, const char *method) const {
	ERR_FAIL_COND_V_MSG(right.is_null(), Handle(), vformat("Multivector.%s: the other multivector is null.", method));
	return make((_value.*operation)(right->_value));
}

Multivector::Handle Multivector::add(const Handle &other) const {
	ERR_FAIL_COND_V_MSG(other.is_null(), Handle(), "Multivector.add: the other multivector is null.");
	return make(_value + other->_value);
}

Multivector::Handle Multivector::subtract(const Handle &other) const {
	ERR_FAIL_COND_V_MSG(other.is_null(), Handle(), "Multivector.subtract: the other multivector is null.");
	return make(_value - other->_value);
}

Multivector::Handle Multivector::scaled(double factor) const {
	ERR_FAIL_COND_V_MSG(!std::isfinite(factor), Handle(), "Multivector.scaled: the factor is not finite.");
	return make(_value * factor);
}

static double finite_or_zero(double value, const char *method) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(value), 0.0, vformat("Multivector.%s: the result is beyond the range of 64-bit floats.", method));
	return value;
}

double Multivector::scalar_product(const Handle &right) const {
	ERR_FAIL_COND_V_MSG(right.is_null(), 0.0, "Multivector.scalar_product: the other multivector is null.");
	return finite_or_zero(_value.scalar_product(right->_value), "scalar_product");
}

Multivector::Handle Multivector::sandwich(const Handle &x) const {
	ERR_FAIL_COND_V_MSG(x.is_null(), Handle(), "Multivector.sandwich: the multivector to transform is null.");
	const std::optional<cga::Multivector> image = _value.sandwich(x->_value);
	ERR_FAIL_COND_V_MSG(!image, Handle(), "Multivector.sandwich: this multivector is not a versor (even or odd, with an inverse), so it cannot transform anything.");
	return make(*image);
}

Multivector::Handle Multivector::grade(int64_t grade) const {
	ERR_FAIL_COND_V_MSG(grade < 0 || grade > 5, Handle(), vformat("Multivector.grade: grade %d is not in 0..5.", grade));
	return make(_value.grade(int(grade)));
}

double Multivector::norm() const {
	return finite_or_zero(_value.norm(), "norm");
}

double Multivector::norm_squared() const {
	return finite_or_zero(_value.norm_squared(), "norm_squared");
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

Multivector::Handle Multivector::power(double exponent) const {
	ERR_FAIL_COND_V_MSG(!std::isfinite(exponent), Handle(), "Multivector.power: the exponent is not finite.");
	return make(cga::power(_value, exponent), "power");
}

std::optional<cga::Pose<double>> Multivector::get_pose() const {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(_value);
	return motor ? motor->to_pose() : std::nullopt;
}

Transform3D Multivector::to_transform() const {
	const std::optional<cga::Pose<double>> pose = get_pose();
	ERR_FAIL_COND_V_MSG(!pose, Transform3D(), vformat(NOT_A_MOTOR, "to_transform"));
	return to_godot(*pose);
}

Vector3 Multivector::get_translation() const {
	const std::optional<cga::Pose<double>> pose = get_pose();
	ERR_FAIL_COND_V_MSG(!pose, Vector3(), vformat(NOT_A_MOTOR, "get_translation"));
	return to_godot(pose->translation);
}

Quaternion Multivector::get_rotation() const {
	const std::optional<cga::Pose<double>> pose = get_pose();
	ERR_FAIL_COND_V_MSG(!pose, Quaternion(), vformat(NOT_A_MOTOR, "get_rotation"));
	return to_godot(pose->rotation);
}

double Multivector::get_scale() const {
	const std::optional<cga::Pose<double>> pose = get_pose();
	ERR_FAIL_COND_V_MSG(!pose, 1.0, vformat(NOT_A_MOTOR, "get_scale"));
	return pose->scale;
}

Vector3 Multivector::transform_point(const Vector3 &point) const {
	const std::optional<cga::Pose<double>> pose = get_pose();
	ERR_FAIL_COND_V_MSG(!pose, point, vformat(NOT_A_MOTOR, "transform_point"));
	ERR_FAIL_COND_V_MSG(!is_finite(point), point, "Multivector.transform_point: the point is not finite.");
	return to_godot(pose->translation + pose->scale * (pose->rotation * to_glm(point)));
}

String Multivector::to_text(bool null_basis) const {
	return to_godot(cga::to_text(_value, null_basis));
}

String Multivector::to_latex() const {
	return to_godot(cga::to_latex(_value));
}

String Multivector::to_json() const {
	return to_godot(cga::to_json(_value));
}

Multivector::Handle Multivector::from_json(const String &text) {
	const cga::TextResult<cga::Multivector> value = cga::from_json(to_utf8(text));
	ERR_FAIL_COND_V_MSG(!value, Handle(), vformat("Multivector.from_json: %s.", to_godot(value.error().describe())));
	return make(*value);
}

// The multivector that a variable of an expression stands for; empty if its type is not accepted.
static std::optional<cga::Multivector> to_multivector(const Variant &variable) {
	switch (variable.get_type()) {
		case Variant::INT:
		case Variant::FLOAT:
			return cga::Multivector::scalar(variable);
		case Variant::VECTOR3:
			return cga::euclidean(to_glm(Vector3(variable)));
		case Variant::OBJECT: {
			const Multivector::Handle multivector = variable;
			return multivector.is_valid() ? std::optional(multivector->get_value()) : std::nullopt;
		}
		default:
			return std::nullopt;
	}
}

Multivector::Handle Multivector::evaluate(const String &expression, const Dictionary &variables) {
	playground::Variables values;
	const Array names = variables.keys();
	for (const Variant &name : names) {
		const Variant::Type type = name.get_type();
		ERR_FAIL_COND_V_MSG(type != Variant::STRING && type != Variant::STRING_NAME, Handle(), vformat("Multivector.evaluate: variable names must be strings, not %s.", Variant::get_type_name(type)));
		const Variant &variable = variables[name];
		const std::optional<cga::Multivector> value = to_multivector(variable);
		ERR_FAIL_COND_V_MSG(!value, Handle(), vformat("Multivector.evaluate: the variable \"%s\" must be a Multivector, a number or a Vector3, not %s.", name, Variant::get_type_name(variable.get_type())));
		values.insert_or_assign(to_utf8(name), *value);
	}
	const cga::TextResult<cga::Multivector> result = playground::evaluate(to_utf8(expression), values);
	ERR_FAIL_COND_V_MSG(!result, Handle(), vformat("Multivector.evaluate: %s.", to_godot(result.error().describe())));
	return make(*result);
}

} // namespace ga_godot
