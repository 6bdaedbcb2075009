#include "../measures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

using namespace bench;

TEST_CASE("histogram: percentiles to one percent") {
	const auto histogram = std::make_unique<Histogram>();
	CHECK(std::isnan(histogram->percentile(0.5)));
	for (int i = 1; i <= 1000; ++i) {
		histogram->add(double(i) * 1e-3);
	}
	CHECK(histogram->percentile(0.5) == doctest::Approx(0.5).epsilon(0.011));
	CHECK(histogram->percentile(0.99) == doctest::Approx(0.99).epsilon(0.011));
	CHECK(histogram->percentile(1.0) == doctest::Approx(1.0).epsilon(0.011));
	CHECK(histogram->max() == 1.0);
	histogram->add(0.0);
	histogram->add(INFINITY);
	CHECK(histogram->count() == 1002);
	CHECK(std::isinf(histogram->max()));
}

TEST_CASE("tick bytes: bytes above the mean per tick") {
	TickBytes ticks;
	for (int i = 0; i < 1000; ++i) {
		ticks.add(i == 500 ? 1100 : 100);
	}
	CHECK(ticks.total() == 101000);
	CHECK(ticks.burst(1.0) == doctest::Approx(1100.0 - 101.0));
	CHECK(ticks.burst(0.99) == doctest::Approx(100.0 - 101.0));
	CHECK(ticks.max() == 1100);
}

TEST_CASE("playback: frames without new motion, and the longest time without it") {
	Playback playback;
	for (int frame = 0; frame < 100; ++frame) {
		// Frames 40 to 49 show what frame 39 shows.
		playback.add(frame * 0.01, (frame >= 40 && frame < 50 ? 39 : frame) * 0.01);
	}
	CHECK(playback.frozen_share() == doctest::Approx(0.1));
	CHECK(playback.longest_stall() == doctest::Approx(0.11));
}
