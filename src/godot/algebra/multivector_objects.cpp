#include "godot/algebra/multivector.hpp"

#include "cga/algebra/blade.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/object/classify.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <optional>

// Constructors, incidence of objects, and classification.

namespace ga_godot {

using godot::Dictionary;
using godot::Quaternion;
using godot::String;
using godot::Transform3D;
using godot::TypedArray;
using godot::Vector3;
using godot::vformat;

Multivector::Handle Multivector::scalar(double value) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(value), Handle(), "Multivector.scalar: the value is not finite.");
	return make(cga::Multivector::scalar(value));
}

Multivector::Handle Multivector::basis_blade(int64_t index) {
	ERR_FAIL_COND_V_MSG(index < 0 || index >= cga::BLADE_COUNT, Handle(), vformat("Multivector.basis_blade: index %d is not in 0..31.", index));
	return make(cga::Multivector::basis_blade(int(index)));
}

Multivector::Handle Multivector::basis(const String &name) {
	const std::optional<cga::Multivector> value = cga::Multivector::basis(name.utf8().get_data());
	ERR_FAIL_COND_V_MSG(!value, Handle(), vformat("Multivector.basis: \"%s\" is not a basis element; valid names are like \"1\", \"e3\", \"e12\", \"eo\", \"einf\", \"E\", \"I\".", name));
	return make(*value);
}

Multivector::Handle Multivector::point(const Vector3 &position) {
	ERR_FAIL_COND_V_MSG(!is_finite(position), Handle(), "Multivector.point: the position is not finite.");
	return make(cga::point(to_glm(position)));
}

Multivector::Handle Multivector::translator(const Vector3 &offset) {
	ERR_FAIL_COND_V_MSG(!is_finite(offset), Handle(), "Multivector.translator: the offset is not finite.");
	return make(cga::translator(to_glm(offset)));
}

// The normalized quaternion; empty if it is zero or not finite.
static std::optional<cga::Quaternion<double>> to_unit(const Quaternion &quaternion) {
	const cga::Quaternion<double> value = to_glm(quaternion);
	if (!is_finite(quaternion) || !(glm::length(value) > 0.0)) {
		return std::nullopt;
	}
	return glm::normalize(value);
}

Multivector::Handle Multivector::rotor(const Quaternion &quaternion) {
	const std::optional<cga::Quaternion<double>> rotation = to_unit(quaternion);
	ERR_FAIL_COND_V_MSG(!rotation, Handle(), "Multivector.rotor: the quaternion is zero or not finite; for no rotation, use Quaternion.IDENTITY.");
	return make(cga::rotor(*rotation));
}

Multivector::Handle Multivector::dilator(double scale) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(scale) || !(scale > 0.0), Handle(), vformat("Multivector.dilator: the scale must be positive and finite, not %f.", scale));
	return make(cga::dilator(scale));
}

Multivector::Handle Multivector::motor(const Transform3D &transform) {
	const PoseResult pose = pose_from_transform(transform);
	ERR_FAIL_COND_V_MSG(!pose, Handle(), vformat("Multivector.motor: the transform %s.", cga::describe(pose.error())));
	return make(cga::to_multivector(cga::Motor<double>::from_pose(*pose)));
}

Multivector::Handle Multivector::motor_from(const Vector3 &translation, const Quaternion &rotation, double scale) {
	const std::optional<cga::Quaternion<double>> unit = to_unit(rotation);
	ERR_FAIL_COND_V_MSG(!is_finite(translation), Handle(), "Multivector.motor_from: the translation is not finite.");
	ERR_FAIL_COND_V_MSG(!unit, Handle(), "Multivector.motor_from: the rotation is zero or not finite; for no rotation, use Quaternion.IDENTITY.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(scale) || !(scale > 0.0), Handle(), vformat("Multivector.motor_from: the scale must be positive and finite, not %f.", scale));
	const cga::Pose<double> pose = { to_glm(translation), *unit, scale };
	return make(cga::to_multivector(cga::Motor<double>::from_pose(pose)));
}

// Flats contain the point at infinity: einf ^ X = 0.
static bool is_flat(const Multivector::Handle &object) {
	return object.is_valid() && cga::e_infinity().outer_product(object->get_value()).max_abs() <= 1e-12 * object->get_value().max_abs();
}

Multivector::Handle Multivector::flat_point(const Vector3 &position) {
	return make(cga::flat_point(to_glm(position)), "flat_point");
}

Multivector::Handle Multivector::point_pair(const Vector3 &a, const Vector3 &b) {
	return make(cga::point_pair(to_glm(a), to_glm(b)), "point_pair");
}

Multivector::Handle Multivector::line(const Vector3 &point, const Vector3 &direction) {
	return make(cga::line(to_glm(point), to_glm(direction)), "line");
}

Multivector::Handle Multivector::line_through(const Vector3 &a, const Vector3 &b) {
	return make(cga::line_through(to_glm(a), to_glm(b)), "line_through");
}

Multivector::Handle Multivector::circle(const Vector3 &center, const Vector3 &normal, double radius) {
	return make(cga::circle(to_glm(center), to_glm(normal), radius), "circle");
}

Multivector::Handle Multivector::circle_through(const Vector3 &a, const Vector3 &b, const Vector3 &c) {
	const Handle circle = make(cga::circle_through(to_glm(a), to_glm(b), to_glm(c)), "circle_through");
	if (is_flat(circle)) {
		WARN_PRINT("Multivector.circle_through: the points are collinear, so the result is the line through them.");
	}
	return circle;
}

Multivector::Handle Multivector::plane(const Vector3 &normal, double distance) {
	return make(cga::plane(to_glm(normal), distance), "plane");
}

Multivector::Handle Multivector::plane_through(const Vector3 &a, const Vector3 &b, const Vector3 &c) {
	return make(cga::plane_through(to_glm(a), to_glm(b), to_glm(c)), "plane_through");
}

Multivector::Handle Multivector::sphere(const Vector3 &center, double radius) {
	return make(cga::sphere(to_glm(center), radius), "sphere");
}

Multivector::Handle Multivector::sphere_through(const Vector3 &a, const Vector3 &b, const Vector3 &c, const Vector3 &d) {
	const Handle sphere = make(cga::sphere_through(to_glm(a), to_glm(b), to_glm(c), to_glm(d)), "sphere_through");
	if (is_flat(sphere)) {
		WARN_PRINT("Multivector.sphere_through: the points are coplanar, so the result is the plane through them.");
	}
	return sphere;
}

Multivector::Handle Multivector::binary(BinaryFunction function, const Handle &other, const char *method) const {
	ERR_FAIL_COND_V_MSG(other.is_null(), Handle(), vformat("Multivector.%s: the other multivector is null.", method));
	return make(function(_value, other->_value), method);
}

Multivector::Handle Multivector::meet(const Handle &other) const {
	return binary(&cga::meet, other, "meet");
}

Multivector::Handle Multivector::join(const Handle &other) const {
	return binary(&cga::join, other, "join");
}

Multivector::Handle Multivector::project_onto(const Handle &onto) const {
	return binary(&cga::project_onto, onto, "project_onto");
}

Multivector::Handle Multivector::reject_from(const Handle &from) const {
	return binary(&cga::reject_from, from, "reject_from");
}

Multivector::Handle Multivector::reflect_in(const Handle &mirror) const {
	return binary(&cga::reflect_in, mirror, "reflect_in");
}

// False if coefficients that differ by hundreds of orders of magnitude overflowed in the classification.
static bool is_finite(const cga::Classification &found) {
	const auto is_finite_vector = [](const std::optional<cga::Vector3<double>> &vector) {
		return !vector || (std::isfinite(vector->x) && std::isfinite(vector->y) && std::isfinite(vector->z));
	};
	return is_finite_vector(found.center) && is_finite_vector(found.normal) && is_finite_vector(found.direction) && std::isfinite(found.radius.value_or(0.0)) && std::isfinite(found.distance.value_or(0.0));
}

Dictionary Multivector::classify(bool ipns) const {
	cga::Classification found = cga::classify(_value, ipns);
	if (!is_finite(found)) {
		ERR_PRINT("Multivector.classify: the coefficients differ by too many orders of magnitude to classify; set those that are rounding errors to zero.");
		found = cga::Classification();
		found.ipns = ipns;
	}
	Dictionary result;
	result["kind"] = cga::name_of(found.kind);
	result["ipns"] = found.ipns;
	result["imaginary"] = found.imaginary;
	if (found.center) {
		result["center"] = to_godot(*found.center);
	}
	if (found.radius) {
		result["radius"] = *found.radius;
	}
	if (found.normal) {
		result["normal"] = to_godot(*found.normal);
	}
	if (found.direction) {
		result["direction"] = to_godot(*found.direction);
	}
	if (found.distance) {
		result["distance"] = *found.distance;
	}
	if (found.points) {
		TypedArray<Vector3> points;
		for (const cga::Vector3<double> &point : *found.points) {
			points.push_back(to_godot(point));
		}
		result["points"] = points;
	}
	result["residual"] = found.residual;
	return result;
}

} // namespace ga_godot
