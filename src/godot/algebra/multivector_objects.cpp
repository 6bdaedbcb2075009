#include "godot/algebra/multivector.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/object/construct.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

// Geometric objects, made from the engine's vectors (OPNS). src/cga says what is wrong with them.

namespace ga_godot {

using godot::Vector3;
using godot::vformat;

// A round through points that lie on no round of finite radius is a flat: right, but maybe not what was meant.
static bool is_flat(const Multivector::Handle &p_object) {
	return p_object.is_valid() && cga::e_infinity().outer_product(p_object->get_value()).max_abs() <= 1e-12 * p_object->get_value().max_abs();
}

Multivector::Handle Multivector::flat_point(const Vector3 &p_position) {
	return make(cga::flat_point(to_glm(p_position)), "flat_point");
}

Multivector::Handle Multivector::point_pair(const Vector3 &p_a, const Vector3 &p_b) {
	return make(cga::point_pair(to_glm(p_a), to_glm(p_b)), "point_pair");
}

Multivector::Handle Multivector::line(const Vector3 &p_point, const Vector3 &p_direction) {
	return make(cga::line(to_glm(p_point), to_glm(p_direction)), "line");
}

Multivector::Handle Multivector::line_through(const Vector3 &p_a, const Vector3 &p_b) {
	return make(cga::line_through(to_glm(p_a), to_glm(p_b)), "line_through");
}

Multivector::Handle Multivector::circle(const Vector3 &p_center, const Vector3 &p_normal, double p_radius) {
	return make(cga::circle(to_glm(p_center), to_glm(p_normal), p_radius), "circle");
}

Multivector::Handle Multivector::circle_through(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c) {
	const Handle circle = make(cga::circle_through(to_glm(p_a), to_glm(p_b), to_glm(p_c)), "circle_through");
	if (is_flat(circle)) {
		WARN_PRINT("Multivector.circle_through: the points lie on one straight line, so the result is that line.");
	}
	return circle;
}

Multivector::Handle Multivector::plane(const Vector3 &p_normal, double p_distance) {
	return make(cga::plane(to_glm(p_normal), p_distance), "plane");
}

Multivector::Handle Multivector::plane_through(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c) {
	return make(cga::plane_through(to_glm(p_a), to_glm(p_b), to_glm(p_c)), "plane_through");
}

Multivector::Handle Multivector::sphere(const Vector3 &p_center, double p_radius) {
	return make(cga::sphere(to_glm(p_center), p_radius), "sphere");
}

Multivector::Handle Multivector::sphere_through(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c, const Vector3 &p_d) {
	const Handle sphere = make(cga::sphere_through(to_glm(p_a), to_glm(p_b), to_glm(p_c), to_glm(p_d)), "sphere_through");
	if (is_flat(sphere)) {
		WARN_PRINT("Multivector.sphere_through: the points lie in one plane, so the result is that plane.");
	}
	return sphere;
}

} // namespace ga_godot
