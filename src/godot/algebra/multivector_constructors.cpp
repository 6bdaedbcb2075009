#include "godot/algebra/multivector.hpp"

#include "cga/algebra/blade.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <optional>

namespace ga_godot {

using godot::Quaternion;
using godot::String;
using godot::Transform3D;
using godot::Vector3;
using godot::vformat;

Multivector::Handle Multivector::scalar(double p_value) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_value), Handle(), "Multivector.scalar: the value is not finite.");
	return make(cga::Multivector::scalar(p_value));
}

Multivector::Handle Multivector::basis_blade(int64_t p_index) {
	ERR_FAIL_COND_V_MSG(p_index < 0 || p_index >= cga::BLADE_COUNT, Handle(), vformat("Multivector.basis_blade: index %d is not in 0..31.", p_index));
	return make(cga::Multivector::basis_blade(int(p_index)));
}

Multivector::Handle Multivector::basis(const String &p_name) {
	const std::optional<cga::Multivector> value = cga::Multivector::basis(p_name.utf8().get_data());
	ERR_FAIL_COND_V_MSG(!value, Handle(), vformat("Multivector.basis: \"%s\" names no basis element; names are like \"1\", \"e3\", \"e12\", \"eo\", \"einf\", \"E\", \"I\".", p_name));
	return make(*value);
}

Multivector::Handle Multivector::point(const Vector3 &p_position) {
	ERR_FAIL_COND_V_MSG(!is_finite(p_position), Handle(), "Multivector.point: the position is not finite.");
	return make(cga::point(to_glm(p_position)));
}

Multivector::Handle Multivector::translator(const Vector3 &p_offset) {
	ERR_FAIL_COND_V_MSG(!is_finite(p_offset), Handle(), "Multivector.translator: the offset is not finite.");
	return make(cga::translator(to_glm(p_offset)));
}

// Any finite quaternion but zero is a rotation after normalising.
static bool unit_quaternion(const Quaternion &p_quaternion, cga::Quaternion<double> &r_unit) {
	const cga::Quaternion<double> quaternion = to_glm(p_quaternion);
	if (!is_finite(p_quaternion) || !(glm::length(quaternion) > 0.0)) {
		return false;
	}
	r_unit = glm::normalize(quaternion);
	return true;
}

Multivector::Handle Multivector::rotor(const Quaternion &p_quaternion) {
	cga::Quaternion<double> rotation;
	ERR_FAIL_COND_V_MSG(!unit_quaternion(p_quaternion, rotation), Handle(), "Multivector.rotor: the quaternion is zero or not finite; the identity is Quaternion(0, 0, 0, 1).");
	return make(cga::rotor(rotation));
}

Multivector::Handle Multivector::dilator(double p_scale) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_scale) || !(p_scale > 0.0), Handle(), vformat("Multivector.dilator: scale must be a positive number, not %f.", p_scale));
	return make(cga::dilator(p_scale));
}

Multivector::Handle Multivector::motor(const Transform3D &p_transform) {
	cga::Pose<double> pose;
	const char *fault = pose_from_transform(p_transform, pose);
	ERR_FAIL_COND_V_MSG(fault != nullptr, Handle(), vformat("Multivector.motor: the transform %s.", fault));
	return make(cga::to_multivector(cga::Motor<double>::from_pose(pose)));
}

Multivector::Handle Multivector::motor_from(const Vector3 &p_translation, const Quaternion &p_rotation, double p_scale) {
	cga::Pose<double> pose;
	ERR_FAIL_COND_V_MSG(!is_finite(p_translation), Handle(), "Multivector.motor_from: the translation is not finite.");
	ERR_FAIL_COND_V_MSG(!unit_quaternion(p_rotation, pose.rotation), Handle(), "Multivector.motor_from: the rotation is zero or not finite; no rotation is Quaternion(0, 0, 0, 1).");
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_scale) || !(p_scale > 0.0), Handle(), vformat("Multivector.motor_from: scale must be a positive number, not %f.", p_scale));
	pose.translation = to_glm(p_translation);
	pose.scale = p_scale;
	return make(cga::to_multivector(cga::Motor<double>::from_pose(pose)));
}

} // namespace ga_godot
