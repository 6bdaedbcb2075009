#include "cga/batch/pose_block.hpp"
#include "cga/motor/matrix_pose.hpp"

namespace cga {

void pose_to_row(const Pose<float> &pose, float *row) noexcept {
	const glm::dmat3 linear = linear_of_pose(pose_cast<double>(pose));
	for (int i = 0; i < 3; i++) {
		for (int column = 0; column < 3; column++) {
			row[4 * i + column] = float(linear[column][i]);
		}
		row[4 * i + 3] = pose.translation[i];
	}
}

Pose<float> pose_from_row(const float *row) noexcept {
	glm::dmat3 linear;
	for (int i = 0; i < 3; i++) {
		for (int column = 0; column < 3; column++) {
			linear[column][i] = row[4 * i + column];
		}
	}
	const Vector3<double> translation(row[3], row[7], row[11]);
	if (const Result<Pose<double>, MatrixError> pose = matrix_to_pose(linear, translation)) {
		return pose_cast<float>(*pose);
	}
	Pose<float> moved;
	moved.translation = Vector3<float>(translation);
	return moved;
}

} // namespace cga
