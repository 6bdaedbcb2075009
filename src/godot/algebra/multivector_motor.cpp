#include "godot/algebra/multivector.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <optional>

// What a motor is as a transform.

namespace ga_godot {

using godot::Quaternion;
using godot::Transform3D;
using godot::Vector3;
using godot::vformat;

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

} // namespace ga_godot
