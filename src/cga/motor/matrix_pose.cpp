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

template <class T>
static bool is_finite(const Vector3<T> &vector) noexcept {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

template <class T>
Result<Pose<T>, MatrixError> matrix_to_pose(const glm::mat<3, 3, T> &linear, const Vector3<T> &translation) noexcept {
	if (!is_finite(linear[0]) || !is_finite(linear[1]) || !is_finite(linear[2]) || !is_finite(translation)) {
		return MatrixError::NOT_FINITE;
	}
	const Vector3<T> length(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
	const T longest = std::max({ length.x, length.y, length.z });
	const T shortest = std::min({ length.x, length.y, length.z });
	if (!(shortest > T(0))) {
		return MatrixError::SINGULAR;
	}
	const glm::mat<3, 3, T> directions(linear[0] / length.x, linear[1] / length.y, linear[2] / length.z);
	const T volume = glm::determinant(directions);
	if (std::abs(volume) < T(1e-6)) {
		return MatrixError::SINGULAR;
	}
	if (volume < T(0)) {
		return MatrixError::MIRRORED;
	}
	const T worst_cosine = std::max({ std::abs(glm::dot(directions[0], directions[1])), std::abs(glm::dot(directions[0], directions[2])), std::abs(glm::dot(directions[1], directions[2])) });
	if (longest - shortest > T(UNIFORMITY) * longest || worst_cosine > T(UNIFORMITY)) {
		return MatrixError::NON_UNIFORM;
	}
	Pose<T> pose;
	pose.translation = translation;
	pose.rotation = glm::normalize(glm::quat_cast(directions));
	// The cube root of the product of the lengths, without leaving the range of T.
	pose.scale = longest * std::cbrt((length.x / longest) * (length.y / longest) * (length.z / longest) * volume);
	return pose;
}

template <class T>
Result<Pose<T>, MatrixError> matrix_to_nearest_pose(const glm::mat<3, 3, T> &linear, const Vector3<T> &translation) noexcept {
	const Result<Pose<T>, MatrixError> exact = matrix_to_pose(linear, translation);
	if (exact || exact.error() != MatrixError::NON_UNIFORM) {
		return exact;
	}
	// The rotation R of the polar decomposition linear = R P, by Newton's iteration (Higham, 1986), which converges for any
	// matrix of positive determinant; then the scale s that minimizes |linear - s R| is R : linear / 3.
	glm::mat<3, 3, T> rotation = linear / std::cbrt(glm::determinant(linear));
	for (int i = 0; i < 60; i++) {
		const glm::mat<3, 3, T> next = (rotation + glm::inverse(glm::transpose(rotation))) / T(2);
		const glm::mat<3, 3, T> step = next - rotation;
		rotation = next;
		if (glm::dot(step[0], step[0]) + glm::dot(step[1], step[1]) + glm::dot(step[2], step[2]) < T(1e-24)) {
			break;
		}
	}
	Pose<T> pose;
	pose.translation = translation;
	pose.rotation = glm::normalize(glm::quat_cast(rotation));
	pose.scale = (glm::dot(rotation[0], linear[0]) + glm::dot(rotation[1], linear[1]) + glm::dot(rotation[2], linear[2])) / T(3);
	return pose;
}

template <class T>
glm::mat<3, 3, T> linear_of_pose(const Pose<T> &pose) noexcept {
	return glm::mat3_cast(pose.rotation) * pose.scale;
}

template Result<Pose<double>, MatrixError> matrix_to_pose(const glm::mat<3, 3, double> &, const Vector3<double> &) noexcept;
template Result<Pose<double>, MatrixError> matrix_to_nearest_pose(const glm::mat<3, 3, double> &, const Vector3<double> &) noexcept;
template glm::mat<3, 3, double> linear_of_pose(const Pose<double> &) noexcept;

} // namespace cga
