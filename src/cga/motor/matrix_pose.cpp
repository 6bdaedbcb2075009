#include "cga/motor/matrix_pose.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace cga {

const char *describe(MatrixError error) noexcept {
	switch (error) {
		case MatrixError::NOT_FINITE:
			return "has a value that is not finite (NaN or infinity); check where it was computed";
		case MatrixError::SINGULAR:
			return "has zero scale along an axis; a motor needs a positive scale";
		case MatrixError::MIRRORED:
			return "is mirrored (negative scale), which a motor cannot represent; mirror a child node instead";
		case MatrixError::NON_UNIFORM:
			return "has non-uniform scale or shear; a motor has one uniform scale, so scale a child node instead";
	}
	return "";
}

Result<Pose<double>, MatrixError> matrix_to_pose(const glm::dmat3 &linear, const Vector3<double> &translation) noexcept {
	if (!is_finite(linear[0]) || !is_finite(linear[1]) || !is_finite(linear[2]) || !is_finite(translation)) {
		return MatrixError::NOT_FINITE;
	}
	const Vector3<double> length(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
	const double longest = std::max({ length.x, length.y, length.z });
	const double shortest = std::min({ length.x, length.y, length.z });
	if (!(shortest > 0.0)) {
		return MatrixError::SINGULAR;
	}
	const glm::dmat3 directions(linear[0] / length.x, linear[1] / length.y, linear[2] / length.z);
	const double volume = glm::determinant(directions);
	if (std::abs(volume) < 1e-6) {
		return MatrixError::SINGULAR;
	}
	if (volume < 0.0) {
		return MatrixError::MIRRORED;
	}
	const double worst_cosine = std::max({ std::abs(glm::dot(directions[0], directions[1])), std::abs(glm::dot(directions[0], directions[2])), std::abs(glm::dot(directions[1], directions[2])) });
	if (longest - shortest > UNIFORMITY * longest || worst_cosine > UNIFORMITY) {
		return MatrixError::NON_UNIFORM;
	}
	// The cube root of the product of the lengths, without leaving the range of double.
	const double scale = longest * std::cbrt((length.x / longest) * (length.y / longest) * (length.z / longest) * volume);
	return { std::in_place, translation, glm::normalize(glm::quat_cast(directions)), scale };
}

Result<Pose<double>, MatrixError> matrix_to_nearest_pose(const glm::dmat3 &linear, const Vector3<double> &translation) noexcept {
	const Result<Pose<double>, MatrixError> exact = matrix_to_pose(linear, translation);
	if (exact || exact.error() != MatrixError::NON_UNIFORM) {
		return exact;
	}
	// The rotation R of the polar decomposition linear = R P, by Newton's iteration (Higham, 1986), which converges for any
	// matrix of positive determinant; then the scale s that minimizes |linear - s R| is R : linear / 3.
	glm::dmat3 rotation = linear / std::cbrt(glm::determinant(linear));
	for (int i = 0; i < 60; ++i) {
		const glm::dmat3 next = (rotation + glm::inverse(glm::transpose(rotation))) / 2.0;
		const glm::dmat3 step = next - rotation;
		rotation = next;
		if (glm::dot(step[0], step[0]) + glm::dot(step[1], step[1]) + glm::dot(step[2], step[2]) < 1e-24) {
			break;
		}
	}
	const double scale = (glm::dot(rotation[0], linear[0]) + glm::dot(rotation[1], linear[1]) + glm::dot(rotation[2], linear[2])) / 3.0;
	return Pose<double>{ translation, glm::normalize(glm::quat_cast(rotation)), scale };
}

glm::dmat3 linear_of_pose(const Pose<double> &pose) noexcept {
	return glm::mat3_cast(pose.rotation) * pose.scale;
}

} // namespace cga
