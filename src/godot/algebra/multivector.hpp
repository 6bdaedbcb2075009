#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/algebra/multivector.hpp"
#include "cga/motor/pose.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstdint>
#include <optional>

namespace ga_godot {

/// An element of Cl(4,1) as a resource. Operations return new objects. Documented in doc_classes/Multivector.xml.
class Multivector : public godot::Resource {
	GDCLASS(Multivector, godot::Resource)

public:
	using Handle = godot::Ref<Multivector>;

	/// Returns null and prints an error if a coefficient is not finite.
	static Handle make(const cga::Multivector &value);
	const cga::Multivector &get_value() const { return _value; }
	/// Incremented by each change of the coefficients, so that users can tell whether a cached result is outdated.
	uint64_t get_revision() const { return _revision; }
	/// The pose of a motor of any weight; empty if this is not a motor with a positive scale.
	std::optional<cga::Pose<double>> get_pose() const;

	void set_coefficients(const godot::PackedFloat64Array &coefficients);
	godot::PackedFloat64Array get_coefficients() const;

	static Handle scalar(double value);
	static Handle basis_blade(int64_t index);
	static Handle basis(const godot::String &name);

	static Handle point(const godot::Vector3 &position);
	static Handle flat_point(const godot::Vector3 &position);
	static Handle point_pair(const godot::Vector3 &a, const godot::Vector3 &b);
	static Handle line(const godot::Vector3 &point, const godot::Vector3 &direction);
	static Handle line_through(const godot::Vector3 &a, const godot::Vector3 &b);
	static Handle circle(const godot::Vector3 &center, const godot::Vector3 &normal, double radius);
	static Handle circle_through(const godot::Vector3 &a, const godot::Vector3 &b, const godot::Vector3 &c);
	static Handle plane(const godot::Vector3 &normal, double distance);
	static Handle plane_through(const godot::Vector3 &a, const godot::Vector3 &b, const godot::Vector3 &c);
	static Handle sphere(const godot::Vector3 &center, double radius);
	static Handle sphere_through(const godot::Vector3 &a, const godot::Vector3 &b, const godot::Vector3 &c, const godot::Vector3 &d);

	static Handle translator(const godot::Vector3 &offset);
	static Handle rotor(const godot::Quaternion &quaternion);
	static Handle dilator(double scale);
	static Handle motor(const godot::Transform3D &transform);
	static Handle motor_from(const godot::Vector3 &translation, const godot::Quaternion &rotation, double scale);

	static Handle evaluate(const godot::String &expression, const godot::Dictionary &variables);
	static Handle from_json(const godot::String &text);

	Handle add(const Handle &other) const;
	Handle subtract(const Handle &other) const;
	Handle scaled(double factor) const;
	Handle geometric_product(const Handle &right) const { return binary(&cga::Multivector::geometric_product, right, "geometric_product"); }
	Handle outer_product(const Handle &right) const { return binary(&cga::Multivector::outer_product, right, "outer_product"); }
	Handle inner_product(const Handle &right) const { return binary(&cga::Multivector::inner_product, right, "inner_product"); }
	Handle left_contraction(const Handle &right) const { return binary(&cga::Multivector::left_contraction, right, "left_contraction"); }
	Handle right_contraction(const Handle &right) const { return binary(&cga::Multivector::right_contraction, right, "right_contraction"); }
	Handle regressive_product(const Handle &right) const { return binary(&cga::Multivector::regressive_product, right, "regressive_product"); }
	Handle commutator_product(const Handle &right) const { return binary(&cga::Multivector::commutator_product, right, "commutator_product"); }
	double scalar_product(const Handle &right) const;
	Handle sandwich(const Handle &x) const;

	Handle meet(const Handle &other) const;
	Handle join(const Handle &other) const;
	Handle project_onto(const Handle &onto) const;
	Handle reject_from(const Handle &from) const;
	Handle reflect_in(const Handle &mirror) const;

	Handle reverse() const { return make(_value.reverse()); }
	Handle grade_involution() const { return make(_value.grade_involution()); }
	Handle clifford_conjugate() const { return make(_value.clifford_conjugate()); }
	Handle dual() const { return make(_value.dual()); }
	Handle undual() const { return make(_value.undual()); }
	Handle grade(int64_t grade) const;

	double norm() const;
	double norm_squared() const;
	Handle normalized() const;
	Handle inverse() const;
	Handle exp() const;
	Handle log() const;
	Handle sqrt() const;
	Handle power(double exponent) const;

	bool is_equal_approx(const Handle &other) const;
	bool is_blade() const;
	bool is_versor() const;
	bool is_motor() const;

	godot::Transform3D to_transform() const;
	godot::Vector3 get_translation() const;
	godot::Quaternion get_rotation() const;
	double get_scale() const;
	godot::Vector3 transform_point(const godot::Vector3 &point) const;

	godot::Dictionary classify(bool ipns) const;

	godot::String to_text(bool null_basis) const;
	godot::String to_latex() const;
	godot::String to_json() const;

protected:
	static void _bind_methods();

private:
	using BinaryOperation = cga::Multivector (cga::Multivector::*)(const cga::Multivector &) const;
	Handle binary(BinaryOperation operation, const Handle &right, const char *method) const;
	using BinaryFunction = cga::MultivectorResult (*)(const cga::Multivector &, const cga::Multivector &);
	Handle binary(BinaryFunction function, const Handle &other, const char *method) const;
	// The value, or null and an error that names the method and the reason.
	static Handle make(const cga::MultivectorResult &result, const char *method);

	cga::Multivector _value;
	uint64_t _revision = 0;
};

} // namespace ga_godot
