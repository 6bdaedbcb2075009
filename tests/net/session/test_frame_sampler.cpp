#include "net/session/frame_sampler.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace net;

namespace {

constexpr double TICK = 1.0 / 60.0;
constexpr double SPEED = 2.0; // m/s

cga::Pose<double> at_x(double x) {
	cga::Pose<double> pose;
	pose.translation.x = x;
	return pose;
}

/// The main loop of an engine: in each frame the due ticks, then scripts that move a body by SPEED times the frame's duration.
struct Loop {
	FrameClock clock;
	FrameSampler sampler;
	double now = 0.0;
	double ticked = 0.0;
	double x = 0.0;
	double sampled = 0.0;
	double min_speed = 1e9;
	double max_speed = -1e9;

	void frame(double duration, bool moves = true) {
		now += duration;
		while (ticked + TICK <= now + 1e-9) {
			ticked += TICK;
			clock.tick(TICK);
			sampler.add(clock.frame_time(), at_x(x));
			const double before = sampled;
			sampled = sampler.at(clock.tick_time() - clock.lag()).translation.x;
			min_speed = std::min(min_speed, (sampled - before) / TICK);
			max_speed = std::max(max_speed, (sampled - before) / TICK);
		}
		clock.frame(duration, (now - ticked) / TICK);
		x += moves ? SPEED * duration : 0.0;
	}

	void run(double seconds, double rate, bool moves = true) {
		min_speed = 1e9;
		max_speed = -1e9;
		for (const double end = now + seconds; now < end;) {
			frame(1.0 / rate, moves);
		}
	}
};

} // namespace

TEST_CASE("frame sampler: a body that moves in frames has an even speed at ticks, at any frame rate") {
	for (const double rate : { 20.0, 24.0, 30.0, 45.0, 50.0, 60.0, 72.0, 90.0, 120.0, 144.0 }) {
		CAPTURE(rate);
		Loop loop;
		loop.run(2.0, rate);
		loop.run(3.0, rate);
		CHECK(loop.min_speed > 0.97 * SPEED);
		CHECK(loop.max_speed < 1.03 * SPEED);
		// It lags by a frame, and by the time since the tick at most.
		CHECK(loop.x - loop.sampled < SPEED * (2.0 / rate + TICK + 1e-9));
	}
}

TEST_CASE("frame sampler: frames of uneven duration") {
	Loop loop;
	for (int i = 0; i < 400; ++i) {
		if (i == 100) {
			loop.min_speed = 1e9;
			loop.max_speed = -1e9;
		}
		loop.frame(i % 3 == 0 ? 0.025 : 0.012);
	}
	CHECK(loop.min_speed > 0.9 * SPEED);
	CHECK(loop.max_speed < 1.1 * SPEED);
}

TEST_CASE("frame sampler: a body that stops is at rest at its last pose") {
	Loop loop;
	loop.run(1.0, 45.0);
	CHECK_FALSE(loop.sampler.rests_at(loop.clock.tick_time() - 2.0 * loop.clock.lag()));
	loop.run(0.5, 45.0, false);
	CHECK(loop.sampled == loop.x);
	CHECK(loop.sampler.rests_at(loop.clock.tick_time() - loop.clock.lag()));
	loop.run(0.5, 45.0);
	CHECK(loop.max_speed < 1.2 * SPEED);
}

TEST_CASE("frame sampler: a pause neither raises the lag for long nor breaks the time line") {
	Loop loop;
	loop.run(2.0, 60.0);
	loop.frame(3.0, false);
	CHECK(loop.clock.lag() <= 0.11);
	loop.run(5.0, 60.0);
	loop.run(2.0, 60.0);
	CHECK(loop.min_speed > 0.95 * SPEED);
	CHECK(loop.max_speed < 1.05 * SPEED);
}
