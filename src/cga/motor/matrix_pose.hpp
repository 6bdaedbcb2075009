#pragma once

#include "cga/motor/pose.hpp"
#include "cga/result.hpp"

#include <glm/mat3x3.hpp>

namespace cga {

// Why a matrix is not the linear part of a pose.
enum class MatrixError {
	NOT_FINITE,
	SINGULAR, // a column is zero or in the span of the others
	MIRRORED, // negative determinant
	NON_UNIFORM, // scaled differently along its axes, or sheared
};

// What is wrong with the transform and what to do, as the end of a sentence: "has zero scale ...".
[[nodiscard]] const char *describe(MatrixError error) noexcept;

// The tolerance of a uniform scale, on relative differences of column lengths and on cosines between columns: far above
// the rounding errors that float matrices accumulate, and below any intended non-uniform scale.
inline constexpr double UNIFORMITY = 1e-3;

// The pose x -> translation + linear x, if `linear` is a rotation times a positive scale. The scale is the cube root
// of the determinant.
Result<Pose<double>, MatrixError> matrix_to_pose(const glm::dmat3 &linear, const Vector3<double> &translation) noexcept;

// The pose nearest to x -> translation + linear x: the rotation times scale closest to `linear` in the Frobenius norm. The
// errors are those of matrix_to_pose, except NON_UNIFORM.
Result<Pose<double>, MatrixError> matrix_to_nearest_pose(const glm::dmat3 &linear, const Vector3<double> &translation) noexcept;

// Rotation times scale: column i is the image of axis i, without the translation.
[[nodiscard]] glm::dmat3 linear_of_pose(const Pose<double> &pose) noexcept;

} // namespace cga
