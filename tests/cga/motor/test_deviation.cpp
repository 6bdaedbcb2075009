#include "cga/motor/deviation.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace cga;
using namespace cga_test;

namespace {

constexpr Mode MODES[] = { Mode::LINEAR, Mode::SCREW, Mode::SEPARATE };

double distance_of(const PoseD &first, const PoseD &second, const Vector3D &point) {
	return glm::length(transformed(first, point) - transformed(second, point));
}

} // namespace

TEST_CASE("no point at the lever arm has a larger distance than reported, and one has that distance") {
	Random random(71);
	for (int repeat = 0; repeat < 200; ++repeat) {
		const PoseD first = repeat % 2 == 0 ? random.pose(1.0) : random.rigid_pose(1.0);
		const PoseD second = repeat % 2 == 0 ? random.pose(1.0) : random.rigid_pose(1.0);
		const double lever_arm = random.uniform(0.0, 3.0);
		const Deviation found = deviation(first, second, lever_arm);
		double largest = 0.0;
		Vector3D best(1.0, 0.0, 0.0);
		for (int sample = 0; sample < 4000; ++sample) {
			const Vector3D point = glm::normalize(random.vector(1.0)) * lever_arm;
			const double distance = distance_of(first, second, point);
			best = distance > largest ? point : best;
			largest = std::max(largest, distance);
		}
		// Hill climbing from the best sample, with shrinking steps.
		for (double step = 0.05; step > 1e-6; step *= 0.9) {
			for (int sample = 0; sample < 20; ++sample) {
				const Vector3D point = glm::normalize(best + random.vector(step * lever_arm)) * lever_arm;
				const double distance = distance_of(first, second, point);
				best = distance > largest ? point : best;
				largest = std::max(largest, distance);
			}
		}
		CHECK(found.distance >= largest * (1.0 - 1e-12));
		CHECK(found.distance <= largest * (1.0 + 1e-6));
		CHECK(found.angle == doctest::Approx(angle_between(first.rotation, second.rotation)).epsilon(1e-12));
	}
}

TEST_CASE("known deviations") {
	const PoseD here = { Vector3D(0.0), QuaternionD(1.0, 0.0, 0.0, 0.0), 1.0 };
	const PoseD moved = { Vector3D(3.0, 4.0, 0.0), QuaternionD(1.0, 0.0, 0.0, 0.0), 1.0 };
	const PoseD turned = { Vector3D(0.0), axis_angle(Vector3D(0.0, 0.0, 1.0), PI / 2.0), 1.0 };
	const PoseD grown = { Vector3D(3.0, 4.0, 0.0), QuaternionD(1.0, 0.0, 0.0, 0.0), 2.5 };
	CHECK(deviation(here, here, 1.0).distance == 0.0);
	CHECK(deviation(here, here, 1.0).angle == 0.0);
	CHECK(deviation(here, moved, 7.0).distance == doctest::Approx(5.0).epsilon(1e-15));
	CHECK(deviation(here, turned, 1.0).distance == doctest::Approx(std::sqrt(2.0)).epsilon(1e-15));
	CHECK(deviation(here, turned, 1.0).angle == doctest::Approx(PI / 2.0).epsilon(1e-15));
	CHECK(deviation(here, turned, 0.0).distance == 0.0);
	CHECK(deviation(here, turned, -1.0).distance == 0.0);
	CHECK(deviation(here, grown, 2.0).distance == doctest::Approx(5.0 + 1.5 * 2.0).epsilon(1e-9));
	// q and -q are the same rotation.
	CHECK(deviation({ turned.translation, -turned.rotation, 1.0 }, turned, 1.0).distance == doctest::Approx(0.0));
}

TEST_CASE("the largest deviation along the path, compared with ten thousand weights") {
	Random random(72);
	for (int repeat = 0; repeat < 60; ++repeat) {
		const PoseD from = repeat % 3 == 0 ? random.pose(1.0) : random.rigid_pose(1.0);
		const PoseD to = repeat % 3 == 0 ? random.pose(1.0) : random.rigid_pose(1.0);
		const Mode first = MODES[repeat % 3];
		const Mode second = MODES[(repeat + 1) % 3];
		const PathDeviation found = path_deviation(from, to, first, second, 1.0);
		Deviation largest;
		for (int step = 0; step <= 2000; ++step) {
			const double weight = step / 2000.0;
			const Deviation here = deviation(interpolate(from, to, weight, first), interpolate(from, to, weight, second), 1.0);
			largest.distance = std::max(largest.distance, here.distance);
			largest.angle = std::max(largest.angle, here.angle);
		}
		CHECK(found.distance >= largest.distance * (1.0 - 1e-8));
		CHECK(found.distance <= largest.distance * (1.0 + 1e-4));
		CHECK(found.angle >= largest.angle * (1.0 - 1e-8) - 1e-12);
		CHECK(found.angle <= largest.angle * (1.0 + 1e-4) + 1e-12);
		const Deviation there = deviation(interpolate(from, to, found.distance_weight, first), interpolate(from, to, found.distance_weight, second), 1.0);
		CHECK(there.distance == doctest::Approx(found.distance).epsilon(1e-12));
	}
}

TEST_CASE("the linear blend deviates by 8.2 degrees at 180, 0.9 at 90, 0.03 at 30") {
	const PoseD from = { Vector3D(1.0, 0.0, 0.0), QuaternionD(1.0, 0.0, 0.0, 0.0), 1.0 };
	const auto largest = [&from](double degrees) {
		const QuaternionD turn = axis_angle(Vector3D(0.0, 1.0, 0.0), degrees * PI / 180.0);
		return path_deviation(from, { turn * from.translation, turn, 1.0 }, Mode::LINEAR, Mode::SCREW, 1.0).angle * 180.0 / PI;
	};
	CHECK(largest(180.0) == doctest::Approx(8.24).epsilon(0.01));
	CHECK(largest(90.0) == doctest::Approx(0.92).epsilon(0.02));
	CHECK(largest(30.0) == doctest::Approx(0.033).epsilon(0.05));
}

TEST_CASE("the separate path deviates from the arc by r (1 - cos(a / 2)) in the middle") {
	const QuaternionD turn = axis_angle(Vector3D(0.0, 1.0, 0.0), PI / 2.0);
	const PoseD from = { Vector3D(2.0, 0.0, 0.0), QuaternionD(1.0, 0.0, 0.0, 0.0), 1.0 };
	const PathDeviation found = path_deviation(from, { turn * from.translation, turn, 1.0 }, Mode::SEPARATE, Mode::SCREW, 0.0);
	CHECK(found.distance == doctest::Approx(2.0 * (1.0 - std::cos(PI / 4.0))).epsilon(1e-12));
	CHECK(found.distance_weight == doctest::Approx(0.5).epsilon(1e-6));
	CHECK(found.angle == doctest::Approx(0.0));
}

TEST_CASE("equal modes and equal poses do not deviate") {
	Random random(73);
	for (const Mode mode : MODES) {
		const PoseD from = random.pose();
		const PathDeviation same_mode = path_deviation(from, random.pose(), mode, mode, 1.0);
		CHECK(same_mode.distance == 0.0);
		CHECK(same_mode.angle == 0.0);
		const PathDeviation same_pose = path_deviation(from, from, Mode::LINEAR, mode, 1.0);
		CHECK(same_pose.distance < 1e-12);
		CHECK(same_pose.angle < 1e-12);
	}
}
