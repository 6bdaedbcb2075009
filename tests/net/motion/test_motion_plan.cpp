#include "../motion_scenes.hpp"
#include "net/motion/motion_plan.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

namespace {

constexpr double TICK = 1.0 / 60.0;

struct Outcome {
	double worst = 0.0; // share of the tolerance
	double worst_time = 0.0;
	double bytes = 0.0;
	int segments = 0;
	int failed = 0; // windows that could not be planned
	BodyState state;
};

struct Plan {
	StreamGrid grid{ 0.005f, 1.4f };
	cga::Mode mode = cga::Mode::SEPARATE;
	int ticks = 12; // of a window
	int coarseness = 0;
	int finer = 0;
};

/// Plans a path window by window, as an encoder does, and measures all samples against the segments.
Outcome planned(const Path &path, const std::vector<double> &times, const Plan &plan) {
	Outcome outcome;
	REQUIRE(outcome.state.set_pose(path(0.0), plan.grid));
	MotionPlanner planner(plan.grid, plan.mode);
	MotionModels models;
	MotionCode motion;
	motion.coarseness = plan.coarseness;
	std::vector<uint8_t> bytes;
	RangeEncoder coder(bytes);
	std::vector<MotionSample> samples;
	samples.reserve(times.size());
	for (const double time : times) {
		samples.push_back({ time / TICK, path(time) });
	}
	// Add a sample at the end of the last window.
	const double end = plan.ticks * std::ceil(samples.back().time / plan.ticks - 1e-6);
	if (samples.back().time < end) {
		samples.push_back({ end, path(end * TICK) });
	}
	size_t first = 0;
	for (double begin = 0.0; first < samples.size(); begin += plan.ticks) {
		size_t count = 0;
		while (first + count < samples.size() && samples[first + count].time <= begin + plan.ticks + 1e-6) {
			++count;
		}
		motion.finer = plan.finer;
		planner.plan(outcome.state, begin, plan.ticks, samples.data() + first, count, samples.size() - first, models, motion);
		outcome.failed += motion.must_jump ? 1 : 0;
		const PoseD held = outcome.state.pose(plan.grid);
		std::vector<MotionSegment> segments;
		REQUIRE(code_motion(coder, models, outcome.state, plan.grid, begin, plan.ticks, false, motion, [&](const BodyState &from, const SegmentCode &code, const SegmentSteps &steps, double at) { segments.push_back(from.segment(code, steps, plan.grid, at, plan.mode)); }));
		outcome.segments += motion.active ? motion.count : 0;
		for (size_t k = first; k < first + count; ++k) {
			PoseD shown = held;
			for (const MotionSegment &segment : segments) {
				if (segment.begin <= samples[k].time) {
					shown = segment.pose_at(samples[k].time);
				}
			}
			const double share = error_share(shown, samples[k].pose, plan.grid);
			if (share > outcome.worst) {
				outcome.worst = share;
				outcome.worst_time = samples[k].time * TICK;
			}
		}
		first += count;
	}
	coder.finish();
	outcome.bytes = double(bytes.size());
	return outcome;
}

/// The search uses single precision. In the modes whose path is verified afterwards, it has a margin.
double max_share(cga::Mode mode) {
	return mode == cga::Mode::SEPARATE ? 1.01 : 1.02;
}

} // namespace

TEST_CASE("motion plan: every sample is passed within the tolerance, near the origin and at 10 km") {
	for (const Vector3D &position : { Vector3D(0.0), Vector3D(10000.0, -40.0, -10000.0) }) {
		for (const Motion &motion : motions(position)) {
			for (const double rate : { 20.0, 30.0, 60.0 }) {
				const Outcome outcome = planned(motion.path, regular_times(rate, 2.0), Plan());
				CAPTURE(motion.name);
				CAPTURE(rate);
				CAPTURE(position.x);
				CAPTURE(outcome.worst_time);
				CHECK(outcome.failed == 0);
				CHECK(outcome.worst <= max_share(cga::Mode::SEPARATE));
			}
		}
	}
}

TEST_CASE("motion plan: in coarse windows, errors are larger by at most the factor of the steps, and bodies cost less") {
	for (const cga::Mode mode : { cga::Mode::SEPARATE, cga::Mode::SCREW }) {
		double bytes = 0.0;
		for (int coarseness = 0; coarseness <= 5; ++coarseness) {
			double coarse_bytes = 0.0;
			for (const Motion &motion : motions(Vector3D(0.0))) {
				Plan plan;
				plan.mode = mode;
				plan.ticks = 3;
				plan.coarseness = coarseness;
				const Outcome outcome = planned(motion.path, regular_times(60.0, 4.0), plan);
				CAPTURE(motion.name);
				CAPTURE(coarseness);
				CHECK(outcome.failed == 0);
				// Errors of rotations of many degrees are not quite linear.
				CHECK(outcome.worst <= (1 << coarseness) * (coarseness > 3 ? 1.15 : max_share(mode)));
				coarse_bytes += outcome.bytes;
			}
			CHECK(coarse_bytes < (coarseness == 0 ? 1e9 : 0.95 * bytes));
			bytes = coarse_bytes;
		}
	}
}

TEST_CASE("motion plan: a priority divides the error in coarse windows, and costs nothing in others") {
	for (const Motion &motion : motions(Vector3D(0.0))) {
		Plan plan;
		plan.coarseness = 4;
		plan.finer = 3;
		const Outcome outcome = planned(motion.path, regular_times(60.0, 4.0), plan);
		CAPTURE(motion.name);
		CHECK(outcome.failed == 0);
		CHECK(outcome.worst <= 2.0 * max_share(plan.mode));
		plan.coarseness = 0;
		const double bytes = planned(motion.path, regular_times(60.0, 4.0), plan).bytes;
		CHECK(bytes == planned(motion.path, regular_times(60.0, 4.0), Plan()).bytes);
	}
}

TEST_CASE("motion plan: samples between ticks are passed where the motion is smooth; a kink is delayed to the next tick") {
	for (const Vector3D &position : { Vector3D(0.0), Vector3D(10000.0, -40.0, -10000.0) }) {
		for (const Motion &motion : motions(position)) {
			for (const bool regular : { true, false }) {
				const Outcome outcome = planned(motion.path, regular ? regular_times(210.0, 2.0) : irregular_times(7, 2.0), Plan());
				CAPTURE(motion.name);
				CAPTURE(regular);
				CAPTURE(position.x);
				CAPTURE(outcome.worst_time);
				CHECK(outcome.failed == 0);
				// A kink of 10 m/s may be delayed by half a tick: 80 mm, 16 times the tolerance.
				CHECK(outcome.worst <= (motion.has_kinks ? 16.0 : (regular ? max_share(cga::Mode::SEPARATE) : 2.0)));
			}
		}
	}
}

TEST_CASE("motion plan: all samples are passed, even if there are more than a fit takes") {
	Plan plan;
	plan.ticks = 64;
	for (const Motion &motion : motions(Vector3D(0.0))) {
		if (!motion.has_kinks) {
			const Outcome outcome = planned(motion.path, regular_times(480.0, 3.2), plan);
			CAPTURE(motion.name);
			CAPTURE(outcome.worst_time);
			CHECK(outcome.failed == 0);
			CHECK(outcome.worst <= max_share(cga::Mode::SEPARATE));
		}
	}
}

TEST_CASE("motion plan: the tolerance also holds in other modes, for other window lengths and other tolerances") {
	struct Row {
		cga::Mode mode;
		int ticks;
		StreamGrid grid;
	};
	for (const Row &row : {
				 Row{ cga::Mode::LINEAR, 12, StreamGrid(0.005f, 1.4f) },
				 Row{ cga::Mode::SCREW, 12, StreamGrid(0.005f, 1.4f) },
				 Row{ cga::Mode::SEPARATE, 1, StreamGrid(0.005f, 1.4f) },
				 Row{ cga::Mode::SEPARATE, 3, StreamGrid(0.005f, 1.4f) },
				 Row{ cga::Mode::SEPARATE, 30, StreamGrid(0.005f, 1.4f) },
				 Row{ cga::Mode::SEPARATE, 64, StreamGrid(0.005f, 1.4f) },
				 Row{ cga::Mode::SEPARATE, 12, StreamGrid(0.0005f, 0.05f) },
				 Row{ cga::Mode::SEPARATE, 12, StreamGrid(0.1f, 20.0f) },
		 }) {
		for (const Motion &motion : motions(Vector3D(3.0, 2.0, 1.0))) {
			const Outcome outcome = planned(motion.path, regular_times(60.0, 3.0), { row.grid, row.mode, row.ticks });
			CAPTURE(motion.name);
			CAPTURE(int(row.mode));
			CAPTURE(row.ticks);
			CAPTURE(row.grid.position_step);
			CAPTURE(outcome.worst_time);
			CHECK(outcome.failed == 0);
			// Errors of rotations of many degrees are not quite linear.
			CHECK(outcome.worst <= (row.grid.position_step > 0.01 ? 1.05 : max_share(row.mode)));
		}
	}
}

TEST_CASE("motion plan: gaps in the samples are bridged, and the samples after them are passed") {
	for (const Motion &motion : motions(Vector3D(0.0))) {
		std::vector<double> times = regular_times(60.0, 3.0);
		for (const double from : { 0.5, 1.2, 2.0 }) {
			times.erase(std::remove_if(times.begin(), times.end(), [from](double t) { return t > from && t < from + 0.13; }), times.end());
		}
		const Outcome outcome = planned(motion.path, times, Plan());
		CAPTURE(motion.name);
		CAPTURE(outcome.worst_time);
		CHECK(outcome.failed == 0);
		CHECK(outcome.worst <= max_share(cga::Mode::SEPARATE));
	}
}

TEST_CASE("motion plan: simple motions take few segments and bytes") {
	struct Row {
		std::string name;
		int max_segments; // in 3 s, 15 windows
		double max_bytes;
	};
	const std::vector<Motion> all = motions(Vector3D(5.0, 1.0, -2.0));
	for (const Row &row : {
				 Row{ "rest", 0, 6 },
				 Row{ "line", 15, 40 },
				 Row{ "parabola", 15, 80 },
				 Row{ "slow spin", 15, 50 },
				 Row{ "spin", 15, 60 },
				 Row{ "fast spin", 20, 110 },
				 Row{ "wheel", 25, 130 },
				 Row{ "growth", 40, 400 },
				 Row{ "bounce", 40, 300 },
		 }) {
		const auto motion = std::find_if(all.begin(), all.end(), [&](const Motion &m) { return m.name == row.name; });
		const Outcome outcome = planned(motion->path, regular_times(60.0, 3.0), Plan());
		CAPTURE(row.name);
		CHECK(outcome.segments <= row.max_segments);
		CHECK(outcome.bytes <= row.max_bytes);
		CHECK((row.max_segments == 0) == (outcome.segments == 0));
	}
}

TEST_CASE("motion plan: a body that stops comes to rest and settles to within a grid step, after coarse windows too") {
	cga_test::Random random(61);
	for (int i = 0; i < 90; ++i) {
		const PoseD last = random.rigid_pose(10.0);
		// Half of it leads beyond the coarsest tolerance; a body within it would not start to move.
		const Vector3D displacement = glm::normalize(random.vector(1.0)) * random.uniform(2.5, 6.0);
		const Path path = [&](double t) {
			PoseD pose = last;
			pose.translation += displacement * std::min(t - 0.5, 0.0);
			return pose;
		};
		Plan plan;
		plan.coarseness = i % 9;
		const Outcome outcome = planned(path, regular_times(60.0, 2.0), plan);
		CAPTURE(plan.coarseness);
		CHECK_FALSE(outcome.state.active);
		CHECK(outcome.state.rest_corrected);
		const PoseD shown = outcome.state.pose(plan.grid);
		for (int axis = 0; axis < 3; ++axis) {
			CHECK(std::abs(shown.translation[axis] - last.translation[axis]) <= plan.grid.position_step);
		}
		CHECK(cga_test::angle_between(shown.rotation, last.rotation) <= plan.grid.rotation_step * std::sqrt(3.0));
	}
}

TEST_CASE("motion plan: jitter within the tolerance is not motion") {
	const Path path = [](double t) {
		const int64_t i = std::llround(t * 60.0);
		return turned_at(Vector3D(noise(i, 0), noise(i, 1), noise(i, 2)) * 0.001, Vector3D(0, 1, 0), 0.002 * noise(i, 3));
	};
	const Outcome outcome = planned(path, regular_times(60.0, 10.0), Plan());
	CHECK(outcome.segments == 0);
	CHECK(outcome.bytes < 20);
}

TEST_CASE("motion plan: a displacement that no code reaches is rejected: the body has to jump") {
	const Plan plan;
	BodyState state;
	REQUIRE(state.set_pose(PoseD(), plan.grid));
	MotionPlanner planner(plan.grid, plan.mode);
	MotionModels models;
	MotionCode motion;
	PoseD far;
	far.translation.x = 1e6;
	const MotionSample sample{ 3.0, far };
	planner.plan(state, 0.0, 12, &sample, 1, 1, models, motion);
	CHECK(motion.must_jump);
	CHECK_FALSE(motion.active);
	CHECK_FALSE(motion.has_rest_correction);
	PoseD grown;
	grown.scale = 1000.0;
	const MotionSample growth{ 3.0, grown };
	planner.plan(state, 0.0, 12, &growth, 1, 1, models, motion);
	CHECK_FALSE(motion.must_jump); // 10 octaves in 3 ticks
	planner.plan(state, 0.0, 12, nullptr, 0, 0, models, motion);
	CHECK_FALSE(motion.must_jump);
	CHECK_FALSE(motion.active);
}
