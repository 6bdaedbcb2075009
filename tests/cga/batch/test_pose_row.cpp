#include "cga/batch/pose_block.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

TEST_CASE("a row is basis rows with the origin's coordinate after each") {
	const float half = std::sqrt(0.5f);
	float row[ROW_FLOATS];
	pose_to_row({ { 1.0f, 2.0f, 3.0f }, { half, 0.0f, 0.0f, half }, 2.0f }, row); // a rotation by pi / 2 about z
	const float expected[ROW_FLOATS] = { 0, -2, 0, 1, 2, 0, 0, 2, 0, 0, 2, 3 };
	for (size_t entry = 0; entry < ROW_FLOATS; ++entry) {
		CAPTURE(entry);
		CHECK(std::abs(row[entry] - expected[entry]) < 5e-7f);
	}
}

TEST_CASE("a pose survives the conversion to a row and back") {
	Random random(61);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		const Pose<float> pose = pose_cast<float>(random.pose(1e4));
		float row[ROW_FLOATS];
		pose_to_row(pose, row);
		const Pose<float> again = pose_from_row(row);
		CHECK(again.translation == pose.translation);
		CHECK(again.scale == doctest::Approx(pose.scale).epsilon(5e-7));
		CHECK(angle_between(pose_cast<double>(again).rotation, pose_cast<double>(pose).rotation) < 5e-7);
	}
}

TEST_CASE("rotations by pi about every axis; a basis without volume counts as the identity") {
	for (const Vector3D &axis : { Vector3D(1, 0, 0), Vector3D(0, 1, 0), Vector3D(0, 0, 1), Vector3D(1, 1, 0), Vector3D(-1, 2, 3) }) {
		const PoseD pose{ Vector3D(0.0), axis_angle(axis, PI), 0.01 };
		float row[ROW_FLOATS];
		pose_to_row(pose_cast<float>(pose), row);
		CHECK(angle_between(pose_cast<double>(pose_from_row(row)).rotation, pose.rotation) < 1e-6);
	}
	const float nothing[ROW_FLOATS] = { 0, 0, 0, 5, 0, 0, 0, 6, 0, 0, 0, 7 };
	const Pose<float> pose = pose_from_row(nothing);
	CHECK(pose.scale == 1.0f);
	CHECK(pose.rotation == Quaternion<float>(1, 0, 0, 0));
	CHECK(pose.translation == Vector3<float>(5, 6, 7));
}
