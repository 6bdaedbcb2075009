#include "net/motion/motion_sample.hpp"

#include "../motion_scenes.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

TEST_CASE("motion sample: the distance of poses at the center and at the lever arm") {
	const PoseD pose = turned_at(Vector3D(1.0, 2.0, 3.0), Vector3D(1.0, 0.5, 0.0), 0.7);
	CHECK(pose_distance(pose, pose, 2.0) == doctest::Approx(0.0));
	PoseD other = pose;
	other.translation += Vector3D(0.03, 0.0, 0.04);
	CHECK(pose_distance(pose, other, 2.0) == doctest::Approx(0.05));
	other = pose;
	other.rotation = cga_test::axis_angle(Vector3D(0.0, 0.0, 1.0), 0.1) * pose.rotation;
	CHECK(pose_distance(pose, other, 2.0) > 2.0 * 0.1 * std::sqrt(2.0 / 3.0) - 1e-3);
	CHECK(pose_distance(pose, other, 2.0) <= 2.0 * 0.1);
	CHECK(pose_distance(pose, other, 0.0) == doctest::Approx(0.0));
	other = pose;
	other.scale = 1.25;
	CHECK(pose_distance(pose, other, 2.0) == doctest::Approx(0.5));
	CHECK(pose_distance(other, pose, 2.0) == pose_distance(pose, other, 2.0));
}
