#include "net/motion/body_state.hpp"

#include "../../cga/random_poses.hpp"
#include "net/stream/stream_header.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace net;
using cga_test::PoseD;
using cga_test::QuaternionD;
using cga_test::Vector3D;

namespace {

const StreamGrid GRID(0.005f, 1.4f);

/// Segments along a path: each coordinate of the translation is `at(tick)` in steps.
template <class Path>
void follow(BodyState &state, int ticks, int count, const Path &at) {
	for (int i = 1; i <= count; ++i) {
		SegmentCode code;
		code.ticks = ticks;
		SegmentSteps steps{};
		for (int c = 0; c < 3; ++c) {
			steps.end[c] = at(i * ticks) - at((i - 1) * ticks);
			code.residual[c] = int32_t((steps.end[c] - state.predicted(c, ticks)) / StreamGrid::COARSE);
		}
		REQUIRE(state.apply(code, steps, GRID));
	}
}

std::vector<int64_t> numbers(BodyState state) {
	std::vector<int64_t> all;
	state.visit([&](auto &number, int bits) {
		CHECK(bit_width(zigzag(int64_t(number))) <= bits);
		all.push_back(int64_t(number));
	});
	return all;
}

PoseD pose_of(double x) {
	PoseD pose;
	pose.translation.x = x;
	return pose;
}

} // namespace

TEST_CASE("body state: set_pose finds the nearest pose, near the origin and at 10 km") {
	cga_test::Random random(51);
	for (const double distance : { 1.0, 10000.0 }) {
		for (int i = 0; i < 300; ++i) {
			PoseD pose = random.pose(distance);
			pose.rotation = pose.rotation * random.uniform(0.1, 10.0); // any length
			BodyState state;
			REQUIRE(state.set_pose(pose, GRID));
			const PoseD near = state.pose(GRID);
			for (int axis = 0; axis < 3; ++axis) {
				CHECK(std::abs(near.translation[axis] - pose.translation[axis]) <= GRID.position_step * 0.5 + 1e-9);
			}
			CHECK(cga_test::angle_between(near.rotation, glm::normalize(pose.rotation)) < 3e-5);
			CHECK(std::abs(std::log2(near.scale / pose.scale)) <= 0.5 / BodyState::SCALE_LEVELS + 1e-9);
			CHECK(state.is_valid());
			CHECK_FALSE(state.active);
			CHECK(state.rest_corrected);
		}
	}
}

TEST_CASE("body state: poses that are not finite or out of range are rejected without a change") {
	BodyState state;
	REQUIRE(state.set_pose(pose_of(3.0), GRID));
	const std::vector<int64_t> before = numbers(state);
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const double infinity = std::numeric_limits<double>::infinity();
	std::vector<PoseD> rejected;
	for (const double bad : { nan, infinity, -infinity, 1e30, GRID.position_step * double(BodyState::MAX_STEPS) }) {
		rejected.push_back(pose_of(bad));
		PoseD pose;
		pose.translation.z = -std::abs(bad);
		rejected.push_back(pose);
	}
	for (const double bad : { nan, infinity, 0.0, -1.0, 1e-6, 1e6 }) {
		PoseD pose;
		pose.scale = bad;
		rejected.push_back(pose);
	}
	rejected.push_back({ Vector3D(0.0), QuaternionD(0, 0, 0, 0), 1.0 });
	rejected.push_back({ Vector3D(0.0), QuaternionD(nan, 0, 0, 0), 1.0 });
	rejected.push_back({ Vector3D(0.0), QuaternionD(1, infinity, 0, 0), 1.0 });
	for (const PoseD &pose : rejected) {
		CAPTURE(pose.translation.x);
		CAPTURE(pose.scale);
		CHECK_FALSE(state.set_pose(pose, GRID));
		CHECK(numbers(state) == before);
	}
	PoseD farthest = pose_of(GRID.position_step * double(BodyState::MAX_STEPS - 1));
	farthest.scale = 65536.0;
	CHECK(state.set_pose(farthest, GRID));
	CHECK(state.is_valid());
	farthest.scale = 1.0 / 65536.0;
	CHECK(state.set_pose(farthest, GRID));
}

TEST_CASE("body state: rest, steady motion and free fall are predicted") {
	struct Row {
		int64_t speed; // steps per tick
		int ticks;
		int64_t max_error;
	};
	for (const Row &row : { Row{ 97, 6, 1 }, Row{ -100000, 3, 1 }, Row{ 0, 10, 0 } }) {
		BodyState state;
		REQUIRE(state.set_pose(PoseD(), GRID));
		follow(state, row.ticks, 8, [&](int64_t tick) { return row.speed * tick; });
		CAPTURE(row.speed);
		for (int c = 0; c < 3; ++c) {
			CHECK(std::abs(state.predicted(c, row.ticks) - row.speed * row.ticks) <= row.max_error);
			CHECK(std::abs(state.predicted(c, 1) - row.speed) <= row.max_error);
			CHECK(state.predicted(3 + c, row.ticks) == 0);
		}
	}
	// A fall of 9.81 m/s^2 at 60 Hz, in windows of 12 ticks with their curvature: the next window's displacement is predicted to a few percent.
	BodyState state;
	REQUIRE(state.set_pose(PoseD(), GRID));
	const double g = -0.5 * 9.81 / 3600.0 / GRID.position_step; // steps per tick^2
	int64_t displacement = 0;
	for (int i = 0; i < 10; ++i) {
		SegmentCode code;
		code.ticks = 12;
		SegmentSteps steps{};
		const auto at = [g](int tick) { return int64_t(std::llround(g * tick * tick)); };
		displacement = at(12 * (i + 1)) - at(12 * i);
		steps.end[1] = displacement;
		steps.curvature[1] = int64_t(std::llround(-g * 144.0));
		code.curved[0] = true;
		code.curvature[1] = int32_t(steps.curvature[1] / StreamGrid::CURVATURE);
		REQUIRE(state.apply(code, steps, GRID));
	}
	const double next = g * (132.0 * 132.0 - 120.0 * 120.0);
	CHECK(std::abs(double(state.predicted(1, 12)) - next) < std::abs(next) * 0.06);
	CHECK(std::abs(double(displacement) - next) > std::abs(next) * 0.08); // repeating the last displacement would be worse
}

TEST_CASE("body state: after reset_motion no motion is predicted") {
	BodyState state;
	REQUIRE(state.set_pose(PoseD(), GRID));
	follow(state, 5, 5, [](int64_t tick) { return 30 * tick; });
	CHECK(state.active);
	CHECK_FALSE(state.rest_corrected);
	const PoseD before = state.pose(GRID);
	state.reset_motion();
	CHECK_FALSE(state.active);
	CHECK(cga_test::difference(state.pose(GRID), before) == 0.0);
	for (int c = 0; c < 6; ++c) {
		CHECK(state.predicted(c, 20) == 0);
	}
	const int32_t offset[6] = { 3, -4, 5, 6, 0, -7 };
	REQUIRE(state.correct_rest(offset, GRID));
	CHECK(state.rest_corrected);
	const PoseD after = state.pose(GRID);
	CHECK(glm::length(after.translation - before.translation - Vector3D(3, -4, 5) * GRID.position_step) < 1e-12);
	CHECK(cga_test::angle_between(before.rotation, after.rotation) == doctest::Approx(std::sqrt(85.0) * GRID.rotation_step).epsilon(0.01));
}

TEST_CASE("body state: motions out of range are rejected without a change") {
	BodyState state;
	REQUIRE(state.set_pose(pose_of(GRID.position_step * double(BodyState::MAX_STEPS - 10)), GRID));
	const std::vector<int64_t> before = numbers(state);
	SegmentCode code;
	SegmentSteps steps{};
	steps.end[0] = 11;
	CHECK_FALSE(state.apply(code, steps, GRID));
	steps.end[0] = 0;
	steps.end[4] = int64_t(20.0 / GRID.rotation_step); // radians
	CHECK_FALSE(state.apply(code, steps, GRID));
	steps.end[4] = 0;
	code.scaled = true;
	code.scale_change = BodyState::MAX_SCALE + 1;
	CHECK_FALSE(state.apply(code, steps, GRID));
	code.scale_change = -ResidualModel::MAX_MAGNITUDE;
	CHECK_FALSE(state.apply(code, steps, GRID));
	const int32_t far[6] = { 11, 0, 0, 0, 0, 0 };
	CHECK_FALSE(state.correct_rest(far, GRID));
	const int32_t turned[6] = { 0, 0, 0, (16 << BodyState::MAX_COARSENESS) + 1, 0, 0 };
	CHECK_FALSE(state.correct_rest(turned, GRID));
	CHECK(numbers(state) == before);
	code.scale_change = BodyState::MAX_SCALE;
	CHECK(state.apply(code, steps, GRID));
	CHECK(state.is_valid());
}

TEST_CASE("body state: visit covers the whole state, and the hash depends on pose and scale") {
	cga_test::Random random(52);
	for (int i = 0; i < 200; ++i) {
		BodyState state;
		REQUIRE(state.set_pose(random.pose(100.0), GRID));
		for (int k = 0; k < i % 5; ++k) {
			SegmentCode code;
			code.ticks = 1 + int(random.uniform(0.0, 63.9));
			for (int c = 0; c < 6; ++c) {
				code.residual[c] = int32_t(random.uniform(-2000.0, 2000.0) / (c < 3 ? 1.0 : 10.0) - double(state.predicted(c, code.ticks)) / StreamGrid::COARSE);
				code.curvature[c] = int32_t(random.uniform(-200.0, 200.0));
			}
			code.curved[k % 2] = true;
			code.scaled = k % 3 == 0;
			code.scale_change = 17;
			REQUIRE(state.apply(code, state.steps(code), GRID));
		}
		std::vector<uint8_t> bytes;
		RangeEncoder encoder(bytes);
		StateCoder<RangeEncoder> writer(encoder);
		state.visit(writer);
		encoder.finish();
		CHECK(bytes.size() <= 96);
		CHECK((i % 5 != 0 || bytes.size() <= 26));
		BodyState read;
		RangeDecoder decoder(bytes.data(), bytes.size());
		StateCoder<RangeDecoder> reader(decoder);
		read.visit(reader);
		CHECK(read.is_valid());
		CHECK(numbers(read) == numbers(state));
		CHECK(read.hash() == state.hash());
		for (int c = 0; c < 6; ++c) {
			CHECK(read.predicted(c, 7) == state.predicted(c, 7));
		}
	}
	BodyState a;
	BodyState b;
	REQUIRE(a.set_pose(pose_of(1.0), GRID));
	REQUIRE(b.set_pose(pose_of(1.0 + GRID.position_step), GRID));
	CHECK(a.hash() != b.hash());
	PoseD scaled = pose_of(1.0);
	scaled.scale = 1.001;
	REQUIRE(b.set_pose(scaled, GRID));
	CHECK(a.hash() != b.hash());
}

TEST_CASE("body state: a planar body codes neither z nor the rotation about x and y") {
	cga_test::Random random(53);
	for (int i = 0; i < 200; ++i) {
		BodyState state;
		state.planar = true;
		const PoseD pose{ Vector3D(random.uniform(-100.0, 100.0), random.uniform(-100.0, 100.0), 0.0), cga_test::axis_angle(Vector3D(0, 0, 1), random.uniform(-3.1, 3.1)), 1.0 };
		REQUIRE(state.set_pose(pose, GRID));
		BodyState spatial;
		REQUIRE(spatial.set_pose(pose, GRID));
		CHECK(cga_test::difference(state.pose(GRID), spatial.pose(GRID)) == 0.0);
		CHECK(numbers(state).size() == numbers(spatial).size() - 2);
		for (int k = 0; k < i % 5; ++k) {
			std::vector<uint8_t> bytes;
			RangeEncoder encoder(bytes);
			MotionModels models;
			SegmentCode code;
			code.ticks = 12;
			for (const int c : { 0, 1, 5 }) {
				code.residual[c] = int32_t(random.uniform(-20.0, 20.0));
				code.curvature[c] = int32_t(random.uniform(-20.0, 20.0));
			}
			code.curved[k % 2] = true;
			state.code(encoder, models, code);
			encoder.finish();
			// The decoder's code still has the numbers of another body.
			SegmentCode read;
			read.ticks = 12;
			std::fill_n(read.residual, 6, 99);
			std::fill_n(read.curvature, 6, 99);
			RangeDecoder decoder(bytes.data(), bytes.size());
			MotionModels other_models;
			state.code(decoder, other_models, read);
			for (int c = 0; c < 6; ++c) {
				CHECK(read.residual[c] == code.residual[c]);
				CHECK((!code.curved[c / 3] || read.curvature[c] == code.curvature[c]));
			}
			REQUIRE(state.apply(code, state.steps(code), GRID));
			CHECK(state.planar);
			CHECK(state.is_valid());
			CHECK(state.pose(GRID).translation.z == 0.0);
			CHECK(state.pose(GRID).rotation.x == 0.0);
			CHECK(state.pose(GRID).rotation.y == 0.0);
		}
		std::vector<uint8_t> bytes;
		RangeEncoder encoder(bytes);
		StateCoder<RangeEncoder> writer(encoder);
		state.visit(writer);
		encoder.finish();
		BodyState read;
		RangeDecoder decoder(bytes.data(), bytes.size());
		StateCoder<RangeDecoder> reader(decoder);
		read.visit(reader);
		CHECK(read.planar);
		CHECK(read.is_valid());
		CHECK(numbers(read) == numbers(state));
		CHECK(cga_test::difference(read.pose(GRID), state.pose(GRID)) == 0.0);
		CHECK(read.hash() == state.hash());
		const int32_t correction[6] = { 3, -4, 0, 0, 0, -7 };
		state.reset_motion();
		REQUIRE(state.correct_rest(correction, GRID));
		CHECK(state.planar);
		CHECK(state.is_valid());
	}
}

TEST_CASE("body state: a planar body out of its plane is not valid") {
	for (const Vector3D &axis : { Vector3D(1, 0, 0), Vector3D(0, 1, 0) }) {
		BodyState state;
		REQUIRE(state.set_pose({ Vector3D(0.0), cga_test::axis_angle(axis, 3.0), 1.0 }, GRID));
		CHECK(state.is_valid());
		state.planar = true;
		CHECK_FALSE(state.is_valid());
	}
	BodyState state;
	REQUIRE(state.set_pose({ Vector3D(0.0, 0.0, 1.0), QuaternionD(1, 0, 0, 0), 1.0 }, GRID));
	CHECK(state.is_valid());
	state.planar = true;
	CHECK_FALSE(state.is_valid());
}
