#include "cga/motor/matrix_pose.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {

using cga::linear_of_pose;
using cga::matrix_to_pose;
using cga::MatrixFault;
using cga::Pose;

glm::dmat3 diagonal(double x, double y, double z) {
	glm::dmat3 matrix(0.0);
	matrix[0][0] = x;
	matrix[1][1] = y;
	matrix[2][2] = z;
	return matrix;
}

MatrixFault fault_of(const glm::dmat3 &linear, const glm::dvec3 &translation = glm::dvec3(0.0)) {
	Pose<double> pose;
	pose.scale = 7.0;
	const MatrixFault fault = matrix_to_pose(linear, translation, pose);
	if (fault != MatrixFault::NONE) {
		CHECK(pose.scale == 7.0);
		CHECK(pose.rotation.w == 1.0);
	}
	return fault;
}

} // namespace

TEST_CASE("a pose goes into a matrix and comes back") {
	cga_test::Random random(7);
	for (int i = 0; i < 2000; i++) {
		const Pose<double> pose = random.pose();
		Pose<double> back;
		REQUIRE(matrix_to_pose(linear_of_pose(pose), pose.translation, back) == MatrixFault::NONE);
		CHECK(back.translation == pose.translation);
		CHECK(std::abs(back.scale / pose.scale - 1.0) < 1e-14);
		CHECK(std::abs(std::abs(glm::dot(back.rotation, pose.rotation)) - 1.0) < 1e-14);
		const glm::dmat3 again = linear_of_pose(back);
		for (int column = 0; column < 3; column++) {
			CHECK(glm::length(again[column] - linear_of_pose(pose)[column]) < 1e-14 * pose.scale);
		}
	}
}

TEST_CASE("column i of a pose's matrix is where it carries axis i") {
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
		Pose<double> pose;
		REQUIRE(matrix_to_pose(diagonal(scale, scale, scale), glm::dvec3(0.0), pose) == MatrixFault::NONE);
		CHECK(std::abs(pose.scale / scale - 1.0) < 1e-14);
		CHECK(pose.rotation.w == 1.0);
	}
}

TEST_CASE("small unevenness is taken for rounding, and the scale is the cube root of the determinant") {
	Pose<double> pose;
	REQUIRE(matrix_to_pose(diagonal(2.0, 2.001, 2.0), glm::dvec3(0.0), pose) == MatrixFault::NONE);
	CHECK(std::abs(pose.scale - std::cbrt(2.0 * 2.001 * 2.0)) < 1e-14);
}

TEST_CASE("what is no pose is named, and leaves the pose alone") {
	const double infinity = std::numeric_limits<double>::infinity();
	const double nan = std::numeric_limits<double>::quiet_NaN();
	CHECK(fault_of(diagonal(1.0, 1.0, 1.0)) == MatrixFault::NONE);
	CHECK(fault_of(diagonal(nan, 1.0, 1.0)) == MatrixFault::NOT_FINITE);
	CHECK(fault_of(diagonal(1.0, 1.0, infinity)) == MatrixFault::NOT_FINITE);
	CHECK(fault_of(diagonal(1.0, 1.0, 1.0), glm::dvec3(0.0, nan, 0.0)) == MatrixFault::NOT_FINITE);
	CHECK(fault_of(diagonal(0.0, 0.0, 0.0)) == MatrixFault::NO_SIZE);
	CHECK(fault_of(diagonal(1.0, 0.0, 1.0)) == MatrixFault::NO_SIZE);
	CHECK(fault_of(diagonal(-1.0, 1.0, 1.0)) == MatrixFault::MIRRORED);
	CHECK(fault_of(diagonal(-1.0, -1.0, -1.0)) == MatrixFault::MIRRORED);
	CHECK(fault_of(diagonal(1.0, 2.0, 1.0)) == MatrixFault::NOT_UNIFORM);
	CHECK(fault_of(diagonal(1.0, 1.002, 1.0)) == MatrixFault::NOT_UNIFORM);
	glm::dmat3 flat(1.0);
	flat[2] = flat[0] + flat[1];
	CHECK(fault_of(flat) == MatrixFault::NO_SIZE);
	glm::dmat3 sheared(1.0);
	sheared[1] = glm::dvec3(std::sin(0.01), std::cos(0.01), 0.0);
	CHECK(fault_of(sheared) == MatrixFault::NOT_UNIFORM);
	CHECK(fault_of(diagonal(-1.0, -1.0, 1.0)) == MatrixFault::NONE); // half a turn about z
}

TEST_CASE("the nearest pose: no rotation and scale near by differs less") {
	cga_test::Random random(8);
	for (int i = 0; i < 200; i++) {
		const Pose<double> stretched = random.pose();
		glm::dmat3 linear = linear_of_pose(stretched) * diagonal(random.uniform(0.2, 3.0), random.uniform(0.2, 3.0), random.uniform(0.2, 3.0));
		linear[0] += 0.1 * linear[1];
		Pose<double> nearest;
		REQUIRE(cga::matrix_to_nearest_pose(linear, stretched.translation, nearest) == MatrixFault::NONE);
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
		Pose<double> nearest, exact;
		REQUIRE(cga::matrix_to_nearest_pose(linear_of_pose(pose), pose.translation, nearest) == MatrixFault::NONE);
		REQUIRE(matrix_to_pose(linear_of_pose(pose), pose.translation, exact) == MatrixFault::NONE);
		CHECK(nearest.rotation == exact.rotation);
		CHECK(nearest.scale == exact.scale);
	}
	Pose<double> left;
	left.scale = 7.0;
	CHECK(cga::matrix_to_nearest_pose(diagonal(1.0, 2.0, -1.0), glm::dvec3(0.0), left) == MatrixFault::MIRRORED);
	CHECK(cga::matrix_to_nearest_pose(diagonal(1.0, 0.0, 1.0), glm::dvec3(0.0), left) == MatrixFault::NO_SIZE);
	CHECK(cga::matrix_to_nearest_pose(diagonal(1.0, std::nan(""), 1.0), glm::dvec3(0.0), left) == MatrixFault::NOT_FINITE);
	CHECK(left.scale == 7.0);
}
