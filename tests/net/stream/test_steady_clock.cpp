#include "net/stream/steady_clock.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace net;

TEST_CASE("steady clock: without jumps, it shows the clock's time") {
	for (const double start : { 0.0, 7.25, 1.7e9 }) {
		SteadyClock clock;
		CHECK_FALSE(clock.is_running());
		for (int i = 0; i < 1000; ++i) {
			const double now = start + i / 60.0;
			CHECK(clock.advance(now) == now);
			CHECK(clock.at(now) == now);
		}
		CHECK(clock.is_running());
	}
}

TEST_CASE("steady clock: any jump counts as a step from 0 to the maximum step, and time goes on at once") {
	for (const double jump : { -1e12, -1e9, -86400.0, -60.0, -1.5, 61.0, 86400.0, 1e9, 9e11 }) {
		CAPTURE(jump);
		SteadyClock clock;
		clock.advance(10.0);
		const double now = std::fabs(jump) > 1e11 ? jump : 10.0 + jump;
		const double expected = jump < 0.0 ? 10.0 : 10.0 + SteadyClock::MAX_STEP;
		CHECK(clock.advance(now) == doctest::Approx(expected).epsilon(1e-4));
		CHECK(clock.advance(now + 0.5) == doctest::Approx(expected + 0.5).epsilon(1e-4));
	}
}

TEST_CASE("steady clock: a small step back makes it wait") {
	SteadyClock clock;
	clock.advance(10.0);
	CHECK(clock.at(9.5) == 9.5);
	CHECK(clock.advance(9.5) == 10.0);
	CHECK(clock.advance(9.9) == 10.0);
	CHECK(clock.advance(10.25) == 10.25);
}

TEST_CASE("steady clock: invalid times change nothing; negative ones begin at 0") {
	SteadyClock clock;
	for (const double invalid : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e13, 1e18, -1e308 }) {
		CHECK_FALSE(is_valid_time(invalid));
		CHECK(clock.advance(invalid) == 0.0);
		CHECK_FALSE(clock.is_running());
	}
	CHECK(clock.advance(-2e9) == 0.0);
	CHECK(clock.advance(-2e9 + 1.0) == 1.0);
	CHECK(clock.advance(1e300) == 1.0);
	CHECK(clock.at(std::numeric_limits<double>::infinity()) == 1.0);
	CHECK(clock.advance(-2e9 + 2.0) == 2.0);
}

TEST_CASE("steady clock: it never decreases and stays finite, whatever the clock does") {
	SteadyClock clock;
	double last = 0.0;
	const double times[] = { 3.0, 1e12, -1e12, 0.0, 2.5, 2.4, 1e11, 5e-324, -7.0, 1e12 };
	for (int i = 0; i < 10000; ++i) {
		const double steady = clock.advance(times[i * 7 % 10]);
		CHECK(steady >= last);
		CHECK(steady <= last + SteadyClock::MAX_STEP + 1e-3);
		last = steady;
	}
}
