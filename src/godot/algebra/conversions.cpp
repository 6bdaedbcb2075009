#include "godot/algebra/conversions.hpp"

#include "cga/motor/matrix_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ga_godot {

static float narrow(double p_value) {
	constexpr double LIMIT = std::numeric_limits<float>::max();
	return float(std::clamp(p_value, -LIMIT, LIMIT));
}

cga::Vector3<double> to_glm(const godot::Vector3 &p_vector) {
	return { p_vector.x, p_vector.y, p_vector.z };
}

cga::Quaternion<double> to_glm(const godot::Quaternion &p_quaternion) {
	return { p_quaternion.w, p_quaternion.x, p_quaternion.y, p_quaternion.z };
}

godot::Vector3 to_godot(const cga::Vector3<double> &p_vector) {
	return godot::Vector3(narrow(p_vector.x), narrow(p_vector.y), narrow(p_vector.z));
}

godot::Quaternion to_godot(const cga::Quaternion<double> &p_quaternion) {
	return godot::Quaternion(narrow(p_quaternion.x), narrow(p_quaternion.y), narrow(p_quaternion.z), narrow(p_quaternion.w));
}

godot::Transform3D to_godot(const cga::Pose<double> &p_pose) {
	const glm::dmat3 linear = cga::linear_of_pose(p_pose);
	godot::Transform3D transform;
	for (int row = 0; row < 3; row++) {
		transform.basis.rows[row] = to_godot(cga::Vector3<double>(linear[0][row], linear[1][row], linear[2][row]));
	}
	transform.origin = to_godot(p_pose.translation);
	return transform;
}

godot::Transform3D transform_from_row(const float *p_row) {
	godot::Transform3D transform;
	for (int i = 0; i < 3; i++) {
		transform.basis.rows[i] = godot::Vector3(p_row[4 * i], p_row[4 * i + 1], p_row[4 * i + 2]);
		transform.origin[i] = p_row[4 * i + 3];
	}
	return transform;
}

std::string to_utf8(const godot::String &p_text) {
	const godot::CharString utf8 = p_text.utf8();
	return std::string(utf8.get_data(), size_t(utf8.length()));
}

godot::String to_godot(const std::string &p_utf8) {
	return godot::String::utf8(p_utf8.data(), int64_t(p_utf8.size()));
}

bool is_finite(const godot::Vector3 &p_vector) {
	return std::isfinite(p_vector.x) && std::isfinite(p_vector.y) && std::isfinite(p_vector.z);
}

bool is_finite(const godot::Quaternion &p_quaternion) {
	return std::isfinite(p_quaternion.x) && std::isfinite(p_quaternion.y) && std::isfinite(p_quaternion.z) && std::isfinite(p_quaternion.w);
}

static glm::dmat3 to_glm(const godot::Basis &p_basis) {
	glm::dmat3 linear;
	for (int row = 0; row < 3; row++) {
		for (int column = 0; column < 3; column++) {
			linear[column][row] = p_basis.rows[row][column];
		}
	}
	return linear;
}

// Stores the pose, or returns the reason why there is none.
static const char *take(const cga::Result<cga::Pose<double>, cga::MatrixError> &p_result, cga::Pose<double> &r_pose) {
	if (!p_result) {
		return cga::describe(p_result.error());
	}
	r_pose = *p_result;
	return nullptr;
}

const char *pose_from_transform(const godot::Transform3D &p_transform, cga::Pose<double> &r_pose) {
	return take(cga::matrix_to_pose(to_glm(p_transform.basis), to_glm(p_transform.origin)), r_pose);
}

const char *nearest_pose_from_transform(const godot::Transform3D &p_transform, cga::Pose<double> &r_pose, bool &r_is_uniform) {
	const glm::dmat3 linear = to_glm(p_transform.basis);
	const cga::Result<cga::Pose<double>, cga::MatrixError> exact = cga::matrix_to_pose(linear, to_glm(p_transform.origin));
	r_is_uniform = exact || exact.error() != cga::MatrixError::NON_UNIFORM;
	return take(r_is_uniform ? exact : cga::matrix_to_nearest_pose(linear, to_glm(p_transform.origin)), r_pose);
}

bool is_mode(int64_t p_mode) {
	return p_mode >= int64_t(cga::Mode::LINEAR) && p_mode <= int64_t(cga::Mode::SEPARATE);
}

} // namespace ga_godot
