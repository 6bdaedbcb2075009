#include "cga/motor/matrix_pose.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {

using cga::linear_of_pose;
using cga::matrix_to_pose;
using cga::MatrixError;
using cga::Pose;

glm::dmat3 diagonal(double x, double y, double z) {
	glm::dmat3 matrix(0.0);
	matrix[0][0] = x;
	matrix[1][1] = y;
	matrix[2][2] = z;
	return matrix;
}

Pose<double> pose_of(const glm::dmat3 &linear, const glm::dvec3 &translation = glm::dvec3(0.0)) {
	const cga::Result<Pose<double>, MatrixError> pose = matrix_to_pose(linear, translation);
	REQUIRE_MESSAGE(pose, describe(pose.error()));
	return *pose;
}

Pose<double> nearest_pose_of(const glm::dmat3 &linear, const glm::dvec3 &translation) {
	const cga::Result<Pose<double>, MatrixError> pose = cga::matrix_to_nearest_pose(linear, translation);
	REQUIRE_MESSAGE(pose, describe(pose.error()));
	return *pose;
}

MatrixError error_of(const glm::dmat3 &linear, const glm::dvec3 &translation = glm::dvec3(0.0)) {
	const cga::Result<Pose<double>, MatrixError> pose = matrix_to_pose(linear, translation);
	REQUIRE_FALSE(pose);
	return pose.error();
}

MatrixError nearest_error_of(const glm::dmat3 &linear) {
	const cga::Result<Pose<double>, MatrixError> pose = cga::matrix_to_nearest_pose(linear, glm::dvec3(0.0));
	REQUIRE_FALSE(pose);
	return pose.error();
}

} // namespace

TEST_CASE("a pose survives the conversion to a matrix and back") {
	cga_test::Random random(7);
	for (int i = 0; i < 2000; i++) {
		const Pose<double> pose = random.pose();
		const Pose<double> back = pose_of(linear_of_pose(pose), pose.translation);
		CHECK(back.translation == pose.translation);
		CHECK(std::abs(back.scale / pose.scale - 1.0) < 1e-14);
		CHECK(std::abs(std::abs(glm::dot(back.rotation, pose.rotation)) - 1.0) < 1e-14);
		const glm::dmat3 again = linear_of_pose(back);
		for (int column = 0; column < 3; column++) {
			CHECK(glm::length(again[column] - linear_of_pose(pose)[column]) < 1e-14 * pose.scale);
		}
	}
}

TEST_CASE("column i of a pose's matrix is the image of axis i") {
	cga_test::Random random(8);
	for (int i = 0; i < 100; i++) {
		const Pose<double> pose = random.pose();
		for (int axis = 0; axis < 3; axis++) {
			glm::dvec3 unit(0.0);
			unit[axis] = 1.0;
			CHECK(glm::length(linear_of_pose(pose)[axis] - pose.scale * (pose.rotation * unit)) < 1e-14 * pose.scale);
		}
	}
}

TEST_CASE("scales far from 1") {
	for (const double scale : { 1e-150, 1e-38, 1e-3, 1e3, 1e38, 1e150 }) {
		const Pose<double> pose = pose_of(diagonal(scale, scale, scale));
		CHECK(std::abs(pose.scale / scale - 1.0) < 1e-14);
		CHECK(pose.rotation.w == 1.0);
	}
}

TEST_CASE("a small deviation from uniform scale counts as rounding, and the scale is the cube root of the determinant") {
	const Pose<double> pose = pose_of(diagonal(2.0, 2.001, 2.0));
	CHECK(std::abs(pose.scale - std::cbrt(2.0 * 2.001 * 2.0)) < 1e-14);
}

TEST_CASE("matrices that are not poses are rejected") {
	const double infinity = std::numeric_limits<double>::infinity();
	const double nan = std::numeric_limits<double>::quiet_NaN();
	CHECK(matrix_to_pose(diagonal(1.0, 1.0, 1.0), glm::dvec3(0.0)));
	CHECK(error_of(diagonal(nan, 1.0, 1.0)) == MatrixError::NOT_FINITE);
	CHECK(error_of(diagonal(1.0, 1.0, infinity)) == MatrixError::NOT_FINITE);
	CHECK(error_of(diagonal(1.0, 1.0, 1.0), glm::dvec3(0.0, nan, 0.0)) == MatrixError::NOT_FINITE);
	CHECK(error_of(diagonal(0.0, 0.0, 0.0)) == MatrixError::SINGULAR);
	CHECK(error_of(diagonal(1.0, 0.0, 1.0)) == MatrixError::SINGULAR);
	CHECK(error_of(diagonal(-1.0, 1.0, 1.0)) == MatrixError::MIRRORED);
	CHECK(error_of(diagonal(-1.0, -1.0, -1.0)) == MatrixError::MIRRORED);
	CHECK(error_of(diagonal(1.0, 2.0, 1.0)) == MatrixError::NON_UNIFORM);
	CHECK(error_of(diagonal(1.0, 1.002, 1.0)) == MatrixError::NON_UNIFORM);
	glm::dmat3 flat(1.0);
	flat[2] = flat[0] + flat[1];
	CHECK(error_of(flat) == MatrixError::SINGULAR);
	glm::dmat3 sheared(1.0);
	sheared[1] = glm::dvec3(std::sin(0.01), std::cos(0.01), 0.0);
	CHECK(error_of(sheared) == MatrixError::NON_UNIFORM);
	CHECK(matrix_to_pose(diagonal(-1.0, -1.0, 1.0), glm::dvec3(0.0))); // a rotation by pi about z
}

TEST_CASE("no rotation and scale close to the nearest pose differs less from the matrix") {
	cga_test::Random random(8);
	for (int i = 0; i < 200; i++) {
		const Pose<double> stretched = random.pose();
		glm::dmat3 linear = linear_of_pose(stretched) * diagonal(random.uniform(0.2, 3.0), random.uniform(0.2, 3.0), random.uniform(0.2, 3.0));
		linear[0] += 0.1 * linear[1];
		const Pose<double> nearest = nearest_pose_of(linear, stretched.translation);
		CHECK(nearest.translation == stretched.translation);
		const auto distance = [&](const Pose<double> &pose) {
			const glm::dmat3 difference = linear_of_pose(pose) - linear;
			return glm::dot(difference[0], difference[0]) + glm::dot(difference[1], difference[1]) + glm::dot(difference[2], difference[2]);
		};
		for (int k = 0; k < 20; k++) {
			Pose<double> other = nearest;
			other.rotation = glm::normalize(glm::dquat(1.0, random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3)) * nearest.rotation);
			other.scale *= random.uniform(0.999, 1.001);
			CHECK(distance(other) >= distance(nearest));
		}
	}
}

TEST_CASE("the nearest pose of a pose's matrix is that pose") {
	cga_test::Random random(9);
	for (int i = 0; i < 200; i++) {
		const Pose<double> pose = random.pose();
		const Pose<double> nearest = nearest_pose_of(linear_of_pose(pose), pose.translation);
		const Pose<double> exact = pose_of(linear_of_pose(pose), pose.translation);
		CHECK(nearest.rotation == exact.rotation);
		CHECK(nearest.scale == exact.scale);
	}
	CHECK(nearest_error_of(diagonal(1.0, 2.0, -1.0)) == MatrixError::MIRRORED);
	CHECK(nearest_error_of(diagonal(1.0, 0.0, 1.0)) == MatrixError::SINGULAR);
	CHECK(nearest_error_of(diagonal(1.0, std::nan(""), 1.0)) == MatrixError::NOT_FINITE);
}
