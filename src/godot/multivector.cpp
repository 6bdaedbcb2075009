#include "godot/multivector.hpp"

#include "cga/algebra/blade.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "godot/conversions.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ga_godot {

using godot::PackedFloat64Array;
using godot::Quaternion;
using godot::String;
using godot::Transform3D;
using godot::Vector3;
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

Multivector::Handle Multivector::binary(BinaryOperation p_operation, const Handle &p_right, const char *p_name) const {
	ERR_FAIL_COND_V_MSG(p_right.is_null(), Handle(), vformat("Multivector.%s: the other multivector is null.", p_name));
	return make((_value.*p_operation)(p_right->_value));
}

Multivector::Handle Multivector::add(const Handle &p_other) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), Handle(), "Multivector.add: the other multivector is null.");
	return make(_value + p_other->_value);
}

Multivector::Handle Multivector::subtract(const Handle &p_other) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), Handle(), "Multivector.subtract: the other multivector is null.");
	return make(_value - p_other->_value);
}

Multivector::Handle Multivector::scaled(double p_factor) const {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_factor), Handle(), "Multivector.scaled: the factor is not finite.");
	return make(_value * p_factor);
}

Multivector::Handle Multivector::geometric_product(const Handle &p_right) const {
	return binary(&cga::Multivector::geometric_product, p_right, "geometric_product");
}

Multivector::Handle Multivector::outer_product(const Handle &p_right) const {
	return binary(&cga::Multivector::outer_product, p_right, "outer_product");
}

Multivector::Handle Multivector::inner_product(const Handle &p_right) const {
	return binary(&cga::Multivector::inner_product, p_right, "inner_product");
}

Multivector::Handle Multivector::left_contraction(const Handle &p_right) const {
	return binary(&cga::Multivector::left_contraction, p_right, "left_contraction");
}

Multivector::Handle Multivector::right_contraction(const Handle &p_right) const {
	return binary(&cga::Multivector::right_contraction, p_right, "right_contraction");
}

double Multivector::scalar_product(const Handle &p_right) const {
	ERR_FAIL_COND_V_MSG(p_right.is_null(), 0.0, "Multivector.scalar_product: the other multivector is null.");
	const double product = _value.scalar_product(p_right->_value);
	ERR_FAIL_COND_V_MSG(!std::isfinite(product), 0.0, "Multivector.scalar_product: the result is beyond the range of 64-bit floats.");
	return product;
}

Multivector::Handle Multivector::sandwich(const Handle &p_x) const {
	ERR_FAIL_COND_V_MSG(p_x.is_null(), Handle(), "Multivector.sandwich: the multivector to transform is null.");
	const std::optional<cga::Multivector> image = _value.sandwich(p_x->_value);
	ERR_FAIL_COND_V_MSG(!image, Handle(), "Multivector.sandwich: this multivector is no versor (even or odd, with an inverse), so it transforms nothing.");
	return make(*image);
}

Multivector::Handle Multivector::reverse() const {
	return make(_value.reverse());
}

Multivector::Handle Multivector::grade_involution() const {
	return make(_value.grade_involution());
}

Multivector::Handle Multivector::clifford_conjugate() const {
	return make(_value.clifford_conjugate());
}

Multivector::Handle Multivector::dual() const {
	return make(_value.dual());
}

Multivector::Handle Multivector::undual() const {
	return make(_value.undual());
}

Multivector::Handle Multivector::grade(int64_t p_grade) const {
	ERR_FAIL_COND_V_MSG(p_grade < 0 || p_grade > 5, Handle(), vformat("Multivector.grade: grade %d is not in 0..5.", p_grade));
	return make(_value.grade(int(p_grade)));
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

bool Multivector::is_equal_approx(const Handle &p_other) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), false, "Multivector.is_equal_approx: the other multivector is null.");
	const double size = std::max({ 1.0, _value.max_abs(), p_other->_value.max_abs() });
	return _value.is_equal_approx(p_other->_value, EQUALITY * size);
}

bool Multivector::is_motor() const {
	return cga::to_motor(_value).has_value();
}

bool Multivector::get_pose(cga::Pose<double> &r_pose) const {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(_value);
	const std::optional<cga::Pose<double>> pose = motor ? motor->to_pose() : std::nullopt;
	if (!pose) {
		return false;
	}
	r_pose = *pose;
	return true;
}

static constexpr const char *NO_MOTOR = "Multivector.%s: this multivector is no motor with positive scale, so it has no transform.";

Transform3D Multivector::to_transform() const {
	cga::Pose<double> pose;
	ERR_FAIL_COND_V_MSG(!get_pose(pose), Transform3D(), vformat(NO_MOTOR, "to_transform"));
	return to_godot(pose);
}

Vector3 Multivector::get_translation() const {
	cga::Pose<double> pose;
	ERR_FAIL_COND_V_MSG(!get_pose(pose), Vector3(), vformat(NO_MOTOR, "get_translation"));
	return to_godot(pose.translation);
}

Quaternion Multivector::get_rotation() const {
	cga::Pose<double> pose;
	ERR_FAIL_COND_V_MSG(!get_pose(pose), Quaternion(), vformat(NO_MOTOR, "get_rotation"));
	return to_godot(pose.rotation);
}

double Multivector::get_scale() const {
	cga::Pose<double> pose;
	ERR_FAIL_COND_V_MSG(!get_pose(pose), 1.0, vformat(NO_MOTOR, "get_scale"));
	return pose.scale;
}

Vector3 Multivector::transform_point(const Vector3 &p_point) const {
	cga::Pose<double> pose;
	ERR_FAIL_COND_V_MSG(!get_pose(pose), p_point, vformat(NO_MOTOR, "transform_point"));
	ERR_FAIL_COND_V_MSG(!is_finite(p_point), p_point, "Multivector.transform_point: the point is not finite.");
	return to_godot(pose.translation + pose.scale * (pose.rotation * to_glm(p_point)));
}

void Multivector::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("set_coefficients", "coefficients"), &Multivector::set_coefficients);
	ClassDB::bind_method(D_METHOD("get_coefficients"), &Multivector::get_coefficients);
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT64_ARRAY, "coefficients"), "set_coefficients", "get_coefficients");

	ClassDB::bind_static_method("Multivector", D_METHOD("scalar", "value"), &Multivector::scalar);
	ClassDB::bind_static_method("Multivector", D_METHOD("basis_blade", "index"), &Multivector::basis_blade);
	ClassDB::bind_static_method("Multivector", D_METHOD("basis", "name"), &Multivector::basis);
	ClassDB::bind_static_method("Multivector", D_METHOD("point", "position"), &Multivector::point);
	ClassDB::bind_static_method("Multivector", D_METHOD("translator", "offset"), &Multivector::translator);
	ClassDB::bind_static_method("Multivector", D_METHOD("rotor", "quaternion"), &Multivector::rotor);
	ClassDB::bind_static_method("Multivector", D_METHOD("dilator", "scale"), &Multivector::dilator);
	ClassDB::bind_static_method("Multivector", D_METHOD("motor", "transform"), &Multivector::motor);
	ClassDB::bind_static_method("Multivector", D_METHOD("motor_from", "translation", "rotation", "scale"), &Multivector::motor_from);

	ClassDB::bind_method(D_METHOD("add", "other"), &Multivector::add);
	ClassDB::bind_method(D_METHOD("subtract", "other"), &Multivector::subtract);
	ClassDB::bind_method(D_METHOD("scaled", "factor"), &Multivector::scaled);
	ClassDB::bind_method(D_METHOD("geometric_product", "right"), &Multivector::geometric_product);
	ClassDB::bind_method(D_METHOD("outer_product", "right"), &Multivector::outer_product);
	ClassDB::bind_method(D_METHOD("inner_product", "right"), &Multivector::inner_product);
	ClassDB::bind_method(D_METHOD("left_contraction", "right"), &Multivector::left_contraction);
	ClassDB::bind_method(D_METHOD("right_contraction", "right"), &Multivector::right_contraction);
	ClassDB::bind_method(D_METHOD("scalar_product", "right"), &Multivector::scalar_product);
	ClassDB::bind_method(D_METHOD("sandwich", "x"), &Multivector::sandwich);

	ClassDB::bind_method(D_METHOD("reverse"), &Multivector::reverse);
	ClassDB::bind_method(D_METHOD("grade_involution"), &Multivector::grade_involution);
	ClassDB::bind_method(D_METHOD("clifford_conjugate"), &Multivector::clifford_conjugate);
	ClassDB::bind_method(D_METHOD("dual"), &Multivector::dual);
	ClassDB::bind_method(D_METHOD("undual"), &Multivector::undual);
	ClassDB::bind_method(D_METHOD("grade", "k"), &Multivector::grade);
	ClassDB::bind_method(D_METHOD("inverse"), &Multivector::inverse);
	ClassDB::bind_method(D_METHOD("normalized"), &Multivector::normalized);
	ClassDB::bind_method(D_METHOD("norm"), &Multivector::norm);
	ClassDB::bind_method(D_METHOD("norm_squared"), &Multivector::norm_squared);

	ClassDB::bind_method(D_METHOD("is_equal_approx", "other"), &Multivector::is_equal_approx);
	ClassDB::bind_method(D_METHOD("is_motor"), &Multivector::is_motor);
	ClassDB::bind_method(D_METHOD("to_transform"), &Multivector::to_transform);
	ClassDB::bind_method(D_METHOD("get_translation"), &Multivector::get_translation);
	ClassDB::bind_method(D_METHOD("get_rotation"), &Multivector::get_rotation);
	ClassDB::bind_method(D_METHOD("get_scale"), &Multivector::get_scale);
	ClassDB::bind_method(D_METHOD("transform_point", "point"), &Multivector::transform_point);
}

} // namespace ga_godot
