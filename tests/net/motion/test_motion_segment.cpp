#include "net/motion/motion_segment.hpp"

#include "../../cga/random_poses.hpp"
#include "net/motion/body_state.hpp"

#include <doctest/doctest.h>

using namespace net;
using cga_test::PoseD;
using cga_test::QuaternionD;
using cga_test::Vector3D;

namespace {

QuaternionD turned(const Vector3D &vector) {
	return glm::length(vector) == 0.0 ? QuaternionD(1, 0, 0, 0) : cga_test::axis_angle(vector, glm::length(vector));
}

MotionSegment random_segment(cga_test::Random &random, cga::Mode mode) {
	MotionSegment segment;
	segment.begin = random.uniform(-100.0, 100.0);
	segment.length = std::floor(random.uniform(1.0, 64.0));
	segment.start = random.pose(20.0);
	segment.scale_ratio = random.uniform(0.3, 3.0);
	segment.displacement = random.vector(2.0);
	segment.translation_curvature = random.vector(1.0);
	segment.rotation = random.vector(0.6);
	segment.rotation_curvature = random.vector(0.4);
	segment.mode = mode;
	return segment;
}

/// The formulas of motion_segment.hpp, with the functions of the C library.
PoseD by_formula(const MotionSegment &s, double u) {
	const double w = u * (1.0 - u);
	PoseD pose;
	pose.scale = s.start.scale * std::pow(s.scale_ratio, u);
	if (s.mode == cga::Mode::SEPARATE) {
		pose.translation = s.start.translation + s.displacement * u + s.translation_curvature * w;
		pose.rotation = s.start.rotation * turned(s.rotation * u + s.rotation_curvature * w);
		return pose;
	}
	const PoseD end{ s.start.translation + s.displacement, s.start.rotation * turned(s.rotation), s.start.scale * s.scale_ratio };
	const PoseD path = cga::interpolate(s.start, end, u, s.mode);
	pose.translation = path.translation + s.translation_curvature * w;
	pose.rotation = path.rotation * turned(s.rotation_curvature * w);
	return pose;
}

constexpr cga::Mode MODES[] = { cga::Mode::LINEAR, cga::Mode::SCREW, cga::Mode::SEPARATE };

} // namespace

TEST_CASE("motion segment: poses follow the formulas in all modes") {
	cga_test::Random random(41);
	for (const cga::Mode mode : MODES) {
		double worst = 0.0;
		for (int i = 0; i < 300; ++i) {
			const MotionSegment segment = random_segment(random, mode);
			for (int step = 0; step <= 16; ++step) {
				const double u = step / 16.0;
				worst = std::max(worst, cga_test::difference(segment.pose_at(segment.begin + u * segment.length), by_formula(segment, u)));
			}
		}
		CAPTURE(int(mode));
		CHECK(worst < 2e-12); // the times themselves are rounded
	}
}

TEST_CASE("motion segment: a parabola as curvature, a rotation by nearly tau, and a screw about an axis off the center") {
	MotionSegment segment;
	segment.begin = 10.0;
	segment.length = 4.0;
	segment.displacement = Vector3D(4.0, 0.0, 0.0);
	segment.translation_curvature = Vector3D(0.0, 8.0, 0.0); // 8 u (1 - u): 2 in the middle
	const PoseD middle = segment.pose_at(12.0);
	CHECK(middle.translation == Vector3D(2.0, 2.0, 0.0));
	CHECK(segment.pose_at(13.0).translation == Vector3D(3.0, 1.5, 0.0));

	MotionSegment turn;
	turn.length = 8.0;
	turn.rotation = Vector3D(0.0, 0.0, 6.0); // nearly tau: half of it is not the shorter rotation
	CHECK(cga_test::angle_between(turn.pose_at(4.0).rotation, turned(Vector3D(0.0, 0.0, 3.0))) < 1e-12);

	MotionSegment screw;
	screw.mode = cga::Mode::SCREW;
	screw.start.translation = Vector3D(1.0, 0.0, 0.0);
	screw.displacement = Vector3D(-1.0, 1.0, 0.0); // with a rotation by pi/2 about the origin
	screw.rotation = Vector3D(0.0, 0.0, cga_test::PI / 2.0);
	const double eighth = std::sqrt(0.5);
	CHECK(glm::length(screw.pose_at(0.5).translation - Vector3D(eighth, eighth, 0.0)) < 1e-12);
	screw.mode = cga::Mode::SEPARATE;
	CHECK(glm::length(screw.pose_at(0.5).translation - Vector3D(0.5, 0.5, 0.0)) < 1e-12);
}

TEST_CASE("motion segment: outside its time span it stays at its ends") {
	cga_test::Random random(42);
	for (const cga::Mode mode : MODES) {
		const MotionSegment segment = random_segment(random, mode);
		CHECK(cga_test::difference(segment.pose_at(segment.begin - 5.0), segment.start) < 1e-14);
		CHECK(cga_test::difference(segment.pose_at(-1e300), segment.start) < 1e-14);
		const PoseD end = segment.pose_at(segment.end());
		CHECK(cga_test::difference(segment.pose_at(segment.end() + 5.0), end) == 0.0);
		CHECK(cga_test::difference(segment.pose_at(1e300), end) == 0.0);
	}
}

TEST_CASE("motion segment: the next segment begins where the last one ends, to within the grid of rotations") {
	cga_test::Random random(43);
	const StreamGrid grid(0.005f, 1.4f);
	for (const cga::Mode mode : MODES) {
		BodyState state;
		REQUIRE(state.set_pose({ Vector3D(10000.0, -3.0, 40.0), random.rotation(), 2.0 }, grid));
		double time = 0.0;
		double gap = 0.0;
		double turn = 0.0;
		for (int i = 0; i < 400; ++i) {
			SegmentCode code;
			code.ticks = 1 + i % 20;
			code.fine = i % 3 == 0;
			for (int c = 0; c < 6; ++c) {
				// Cancel the prediction, so that the body stays near its start.
				const int64_t back = -state.predicted(c, code.ticks) / (code.fine ? StreamGrid::FINE : StreamGrid::COARSE);
				code.residual[c] = int32_t(back + int64_t(random.uniform(-9.0, 9.0)));
				code.curvature[c] = int32_t(random.uniform(-5.0, 5.0));
			}
			code.curved[0] = i % 2 == 0;
			code.curved[1] = i % 5 < 3;
			code.scaled = i % 7 == 0;
			code.scale_change = i % 14 == 0 ? 300 : -300;
			const SegmentSteps steps = state.steps(code);
			const MotionSegment segment = state.segment(code, steps, grid, time, mode);
			CHECK(cga_test::difference(segment.pose_at(time), state.pose(grid)) < 1e-14);
			REQUIRE(state.apply(code, steps, grid));
			const PoseD end = segment.pose_at(segment.end());
			const PoseD reached = state.pose(grid);
			gap = std::max({ gap, glm::length(end.translation - reached.translation), std::abs(end.scale / reached.scale - 1.0) });
			turn = std::max(turn, cga_test::angle_between(end.rotation, reached.rotation));
			time += code.ticks;
		}
		CAPTURE(int(mode));
		CHECK(gap < 1e-11);
		CHECK(turn < 2.0 * std::sqrt(3.0) / LatticeRotation::STEPS);
	}
}
