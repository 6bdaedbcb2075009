#include "cga/motor/matrix_pose.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace cga {

template <class T>
static bool is_finite(const Vector3<T> &vector) noexcept {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

template <class T>
MatrixFault matrix_to_pose(const glm::mat<3, 3, T> &linear, const Vector3<T> &translation, Pose<T> &pose) noexcept {
	if (!is_finite(linear[0]) || !is_finite(linear[1]) || !is_finite(linear[2]) || !is_finite(translation)) {
		return MatrixFault::NOT_FINITE;
	}
	const Vector3<T> length(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
	const T longest = std::max({ length.x, length.y, length.z });
	const T shortest = std::min({ length.x, length.y, length.z });
	if (!(shortest > T(0))) {
		return MatrixFault::NO_SIZE;
	}
	const glm::mat<3, 3, T> directions(linear[0] / length.x, linear[1] / length.y, linear[2] / length.z);
	const T volume = glm::determinant(directions);
	if (std::abs(volume) < T(1e-6)) {
		return MatrixFault::NO_SIZE;
	}
	if (volume < T(0)) {
		return MatrixFault::MIRRORED;
	}
	const T worst_cosine = std::max({ std::abs(glm::dot(directions[0], directions[1])), std::abs(glm::dot(directions[0], directions[2])), std::abs(glm::dot(directions[1], directions[2])) });
	if (longest - shortest > T(UNIFORMITY) * longest || worst_cosine > T(UNIFORMITY)) {
		return MatrixFault::NOT_UNIFORM;
	}
	pose.translation = translation;
	pose.rotation = glm::normalize(glm::quat_cast(directions));
	// The cube root of the product of the lengths, without leaving the range of T.
	pose.scale = longest * std::cbrt((length.x / longest) * (length.y / longest) * (length.z / longest) * volume);
	return MatrixFault::NONE;
}

template <class T>
glm::mat<3, 3, T> linear_of_pose(const Pose<T> &pose) noexcept {
	return glm::mat3_cast(pose.rotation) * pose.scale;
}

template MatrixFault matrix_to_pose(const glm::mat<3, 3, double> &, const Vector3<double> &, Pose<double> &) noexcept;
template glm::mat<3, 3, double> linear_of_pose(const Pose<double> &) noexcept;

} // namespace cga
