#include "../baseline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace bench;

namespace {

constexpr double RATE = 60.0;

// A trace of `count` bodies at 60 Hz, all at x = place(time).
template <class Place>
Trace line_trace(int count, int frames, Place place) {
	Trace trace;
	for (int i = 0; i < count; ++i) {
		trace.bodies.push_back({ uint32_t(i), {} });
	}
	for (int frame = 0; frame < frames; ++frame) {
		const double time = frame / RATE;
		trace.frames.push_back({ time, trace.order.size(), trace.order.size() + size_t(count) });
		for (int i = 0; i < count; ++i) {
			TraceSample sample{ time, {} };
			sample.pose.translation.x = place(time);
			trace.order.push_back({ uint32_t(i), uint32_t(frame) });
			trace.bodies[size_t(i)].samples.push_back(sample);
		}
	}
	return trace;
}

Baseline named(const std::string &subject) {
	for (const Baseline &baseline : baselines()) {
		if (baseline.subject == subject) {
			return baseline;
		}
	}
	FAIL("no baseline " << subject);
	return {};
}

} // namespace

TEST_CASE("baseline: rates, bytes and the playback delay") {
	const Trace trace = line_trace(40, 601, [](double time) { return time; });
	for (const int rate : { 5, 10, 15, 20, 30, 60 }) {
		const MethodResult result = run_baseline(trace, named("pqs_float32_" + std::to_string(rate) + "hz"), {}, 1);
		CHECK(result.bytes_per_second == doctest::Approx(40.0 * 40.0 * (rate + 0.1)));
		// 40 bodies of 40 bytes are two datagrams.
		CHECK(result.packets_per_second == doctest::Approx(2.0 * (rate + 0.1)));
		CHECK(result.delay_max == doctest::Approx(1.0 / rate).epsilon(1e-6));
		CHECK(result.unseen == 0);
	}
	const MethodResult paper = run_baseline(trace, named("paper_motor_float32_10hz"), {}, 1);
	CHECK(paper.bytes_per_second == doctest::Approx(36.0 * 40.0 * 10.1));
	harness::LinkSettings slow;
	slow.delay = 0.02;
	slow.jitter = 0.03;
	CHECK(run_baseline(trace, named("pqs_float32_10hz"), slow, 1).delay_max == doctest::Approx(0.15).epsilon(1e-6));
}

TEST_CASE("baseline: the error of interpolation on a known path") {
	// x = a t^2 deviates from the chord between samples h apart by at most a h^2 / 4, in the middle.
	const Trace trace = line_trace(1, 601, [](double time) { return 0.8 * time * time; });
	const MethodResult result = run_baseline(trace, named("pqs_float32_10hz"), {}, 1);
	CHECK(result.errors.figures().max == doctest::Approx(0.8 * 0.01 / 4.0).epsilon(1e-3));
	// At 60 Hz every sample is sent; the remaining error is the float32 rounding of 80 m.
	const MethodResult all = run_baseline(trace, named("pqs_float32_60hz"), {}, 1);
	CHECK(all.errors.figures().max < 4e-6);
	CHECK(all.errors.figures().max > 0.0);
	// Without rotation the linear blend of motors is lerp.
	CHECK(run_baseline(trace, named("paper_motor_float32_10hz"), {}, 1).errors.figures().max == doctest::Approx(result.errors.figures().max).epsilon(1e-2));
}

TEST_CASE("baseline: float32 motors represent a pose to float32 precision") {
	cga::Pose<double> pose;
	pose.translation = { 12.3, -4.5, 6.7 };
	pose.rotation = glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.1));
	const cga::Pose<double> received = named("paper_motor_float32_5hz").as_received(pose);
	CHECK(lever_distance(pose, received) < 1e-5);
	CHECK(lever_distance(pose, received) > 0.0);
}

TEST_CASE("baseline: the receiver interpolates across a lost sample") {
	const Trace trace = line_trace(1, 2401, [](double time) { return 0.8 * time * time; });
	harness::LinkSettings lossy;
	lossy.loss = 0.05;
	const MethodResult result = run_baseline(trace, named("pqs_float32_10hz"), lossy, 3);
	// Gaps of two intervals have four times the error; about 1 in 20 intervals is in one.
	CHECK(result.errors.figures().p50 < 0.8 * 0.01 / 4.0);
	CHECK(result.errors.figures().p99 > 0.9 * 0.8 * 0.04 / 4.0);
	harness::LinkSettings all_lost;
	all_lost.loss = 1.0;
	const MethodResult nothing = run_baseline(trace, named("pqs_float32_10hz"), all_lost, 3);
	CHECK(nothing.unseen == 2401);
	CHECK(std::isnan(nothing.errors.figures().p99));
}

TEST_CASE("baseline: a body that begins late, ends early and has a gap") {
	Trace trace = line_trace(2, 121, [](double time) { return time; });
	std::vector<TraceSample> &samples = trace.bodies[1].samples;
	samples.erase(samples.begin() + 50, samples.begin() + 70);
	samples.erase(samples.begin(), samples.begin() + 7);
	samples.resize(60);
	trace.order.clear();
	trace.frames.clear();
	for (uint32_t body = 0; body < 2; ++body) {
		for (uint32_t i = 0; i < trace.bodies[body].samples.size(); ++i) {
			trace.order.push_back({ body, i });
		}
	}
	std::stable_sort(trace.order.begin(), trace.order.end(), [&](const SampleIndex &a, const SampleIndex &b) { return trace.sample(a).time < trace.sample(b).time; });
	for (size_t i = 0; i < trace.order.size(); ++i) {
		const double time = trace.sample(trace.order[i]).time;
		if (trace.frames.empty() || trace.frames.back().time != time) {
			trace.frames.push_back({ time, i, i });
		}
		trace.frames.back().end = i + 1;
	}
	const MethodResult result = run_baseline(trace, named("pqs_float32_20hz"), {}, 1);
	CHECK(result.unseen == 0);
	CHECK(result.errors.figures().max < 1e-6);
	CHECK(result.delay_max == doctest::Approx(0.05).epsilon(1e-6));
}
