#pragma once

#include "cga/motor/pose.hpp"

#include <glm/mat3x3.hpp>

namespace cga {

// Why a matrix is not the linear part of a pose.
enum class MatrixFault {
	NONE,
	NOT_FINITE,
	NO_SIZE, // no volume: a column is zero or in the span of the others
	MIRRORED, // negative determinant
	NOT_UNIFORM, // scaled differently along its axes, or sheared
};

// Columns may differ in length, and their cosines from zero, by this much: what float matrices collect over many
// products is far smaller, and what people mean by non-uniform scale is larger.
inline constexpr double UNIFORMITY = 1e-3;

// The pose x -> translation + linear x, if `linear` is a rotation times a positive scale. The scale is the cube root
// of the determinant. On a fault `pose` is left alone.
template <class T>
[[nodiscard]] MatrixFault matrix_to_pose(const glm::mat<3, 3, T> &linear, const Vector3<T> &translation, Pose<T> &pose) noexcept;

// The pose nearest to x -> translation + linear x: of all rotations times a scale, the one that differs least from
// `linear` in the sum of squares of the entries. Never NOT_UNIFORM; the other faults are as above.
template <class T>
[[nodiscard]] MatrixFault matrix_to_nearest_pose(const glm::mat<3, 3, T> &linear, const Vector3<T> &translation, Pose<T> &pose) noexcept;

// Rotation times scale: column i is where the pose carries the i-th axis, without the translation.
template <class T>
[[nodiscard]] glm::mat<3, 3, T> linear_of_pose(const Pose<T> &pose) noexcept;

extern template MatrixFault matrix_to_pose(const glm::mat<3, 3, double> &, const Vector3<double> &, Pose<double> &) noexcept;
extern template MatrixFault matrix_to_nearest_pose(const glm::mat<3, 3, double> &, const Vector3<double> &, Pose<double> &) noexcept;
extern template glm::mat<3, 3, double> linear_of_pose(const Pose<double> &) noexcept;

} // namespace cga
