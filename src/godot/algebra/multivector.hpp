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

namespace ga_godot {

/// An element of Cl(4,1) as a resource. Operations return new objects; doc_classes/Multivector.xml documents them.
class Multivector : public godot::Resource {
	GDCLASS(Multivector, godot::Resource)

public:
	using Handle = godot::Ref<Multivector>;

	/// Null and an error if a coefficient is not finite.
	static Handle make(const cga::Multivector &p_value);
	const cga::Multivector &get_value() const { return _value; }
	/// Goes up with each change in place, so that users of a multivector can keep what they computed from it.
	uint64_t get_revision() const { return _revision; }
	/// The pose of a motor of any weight; false if this is none.
	bool get_pose(cga::Pose<double> &r_pose) const;

	void set_coefficients(const godot::PackedFloat64Array &p_coefficients);
	godot::PackedFloat64Array get_coefficients() const;

	static Handle scalar(double p_value);
	static Handle basis_blade(int64_t p_index);
	static Handle basis(const godot::String &p_name);

	static Handle point(const godot::Vector3 &p_position);
	static Handle flat_point(const godot::Vector3 &p_position);
	static Handle point_pair(const godot::Vector3 &p_a, const godot::Vector3 &p_b);
	static Handle line(const godot::Vector3 &p_point, const godot::Vector3 &p_direction);
	static Handle line_through(const godot::Vector3 &p_a, const godot::Vector3 &p_b);
	static Handle circle(const godot::Vector3 &p_center, const godot::Vector3 &p_normal, double p_radius);
	static Handle circle_through(const godot::Vector3 &p_a, const godot::Vector3 &p_b, const godot::Vector3 &p_c);
	static Handle plane(const godot::Vector3 &p_normal, double p_distance);
	static Handle plane_through(const godot::Vector3 &p_a, const godot::Vector3 &p_b, const godot::Vector3 &p_c);
	static Handle sphere(const godot::Vector3 &p_center, double p_radius);
	static Handle sphere_through(const godot::Vector3 &p_a, const godot::Vector3 &p_b, const godot::Vector3 &p_c, const godot::Vector3 &p_d);

	static Handle translator(const godot::Vector3 &p_offset);
	static Handle rotor(const godot::Quaternion &p_quaternion);
	static Handle dilator(double p_scale);
	static Handle motor(const godot::Transform3D &p_transform);
	static Handle motor_from(const godot::Vector3 &p_translation, const godot::Quaternion &p_rotation, double p_scale);

	static Handle evaluate(const godot::String &p_expression, const godot::Dictionary &p_variables);
	static Handle from_json(const godot::String &p_text);

	Handle add(const Handle &p_other) const;
	Handle subtract(const Handle &p_other) const;
	Handle scaled(double p_factor) const;
	Handle geometric_product(const Handle &p_right) const;
	Handle outer_product(const Handle &p_right) const;
	Handle inner_product(const Handle &p_right) const;
	Handle left_contraction(const Handle &p_right) const;
	Handle right_contraction(const Handle &p_right) const;
	Handle regressive_product(const Handle &p_right) const;
	Handle commutator_product(const Handle &p_right) const;
	double scalar_product(const Handle &p_right) const;
	Handle sandwich(const Handle &p_x) const;

	Handle meet(const Handle &p_other) const;
	Handle join(const Handle &p_other) const;
	Handle project_onto(const Handle &p_onto) const;
	Handle reject_from(const Handle &p_from) const;
	Handle reflect_in(const Handle &p_mirror) const;

	Handle reverse() const;
	Handle grade_involution() const;
	Handle clifford_conjugate() const;
	Handle dual() const;
	Handle undual() const;
	Handle grade(int64_t p_grade) const;

	double norm() const;
	double norm_squared() const;
	Handle normalized() const;
	Handle inverse() const;
	Handle exp() const;
	Handle log() const;
	Handle sqrt() const;
	Handle power(double p_exponent) const;

	bool is_equal_approx(const Handle &p_other) const;
	bool is_blade() const;
	bool is_versor() const;
	bool is_motor() const;

	godot::Transform3D to_transform() const;
	godot::Vector3 get_translation() const;
	godot::Quaternion get_rotation() const;
	double get_scale() const;
	godot::Vector3 transform_point(const godot::Vector3 &p_point) const;

	godot::Dictionary classify(bool p_ipns) const;

	godot::String to_text(bool p_null_basis) const;
	godot::String to_latex() const;
	godot::String to_json() const;

protected:
	static void _bind_methods();

private:
	using BinaryOperation = cga::Multivector (cga::Multivector::*)(const cga::Multivector &) const;
	Handle binary(BinaryOperation p_operation, const Handle &p_right, const char *p_method) const;
	using BinaryFunction = cga::MultivectorResult (*)(const cga::Multivector &, const cga::Multivector &);
	Handle binary(BinaryFunction p_function, const Handle &p_other, const char *p_method) const;
	// The value, or null and the reason why there is none, as an error of that method.
	static Handle make(const cga::MultivectorResult &p_result, const char *p_method);

	cga::Multivector _value;
	uint64_t _revision = 0;
};

} // namespace ga_godot
