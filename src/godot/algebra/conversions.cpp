#include "godot/algebra/conversions.hpp"

#include "cga/motor/matrix_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ga_godot {

static float narrow(double value) {
	constexpr double LIMIT = std::numeric_limits<float>::max();
	return float(std::clamp(value, -LIMIT, LIMIT));
}

cga::Vector3<double> to_glm(const godot::Vector3 &vector) {
	return { vector.x, vector.y, vector.z };
}

cga::Quaternion<double> to_glm(const godot::Quaternion &quaternion) {
	return { quaternion.w, quaternion.x, quaternion.y, quaternion.z };
}

godot::Vector3 to_godot(const cga::Vector3<double> &vector) {
	return godot::Vector3(narrow(vector.x), narrow(vector.y), narrow(vector.z));
}

godot::Quaternion to_godot(const cga::Quaternion<double> &quaternion) {
	return godot::Quaternion(narrow(quaternion.x), narrow(quaternion.y), narrow(quaternion.z), narrow(quaternion.w));
}

godot::Transform3D to_godot(const cga::Pose<double> &pose) {
	const glm::dmat3 linear = cga::linear_of_pose(pose);
	godot::Transform3D transform;
	for (int row = 0; row < 3; row++) {
		transform.basis.rows[row] = to_godot(cga::Vector3<double>(linear[0][row], linear[1][row], linear[2][row]));
	}
	transform.origin = to_godot(pose.translation);
	return transform;
}

godot::Transform3D transform_from_row(const float *row) {
	return { godot::Basis(row[0], row[1], row[2], row[4], row[5], row[6], row[8], row[9], row[10]), godot::Vector3(row[3], row[7], row[11]) };
}

std::string to_utf8(const godot::String &text) {
	const godot::CharString utf8 = text.utf8();
	return std::string(utf8.get_data(), size_t(utf8.length()));
}

godot::String to_godot(const std::string &text) {
	return godot::String::utf8(text.data(), int64_t(text.size()));
}

godot::PackedByteArray to_packed(const uint8_t *bytes, size_t size) {
	godot::PackedByteArray packed;
	packed.resize(int64_t(size));
	std::copy_n(bytes, size, packed.ptrw());
	return packed;
}

bool is_finite(const godot::Vector3 &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool is_finite(const godot::Quaternion &quaternion) {
	return std::isfinite(quaternion.x) && std::isfinite(quaternion.y) && std::isfinite(quaternion.z) && std::isfinite(quaternion.w);
}

static glm::dmat3 to_glm(const godot::Basis &basis) {
	glm::dmat3 linear;
	for (int row = 0; row < 3; row++) {
		for (int column = 0; column < 3; column++) {
			linear[column][row] = basis.rows[row][column];
		}
	}
	return linear;
}

PoseResult pose_from_transform(const godot::Transform3D &transform) {
	return cga::matrix_to_pose(to_glm(transform.basis), to_glm(transform.origin));
}

PoseResult nearest_pose_from_transform(const godot::Transform3D &transform) {
	return cga::matrix_to_nearest_pose(to_glm(transform.basis), to_glm(transform.origin));
}

bool is_mode(int64_t mode) {
	return mode >= int64_t(cga::Mode::LINEAR) && mode <= int64_t(cga::Mode::SEPARATE);
}

} // namespace ga_godot
