#include "net/delivery/playback_clock.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace net;

namespace {

constexpr double FRAME = 1.0 / 60.0;

/// A stream whose windows of 0.05 s arrive `network` after their end, with jitter; frames of 1/60 s.
struct Stream {
	PlaybackClock clock;
	double min_delay = 0.0;
	double max_delay = 0.2;
	std::mt19937 random{ 5 };
	double offset = 1000.0; // local minus media time
	double media = 0.0; // of the last arrival
	double now = 1000.0;
	double min_rate = 1e9;
	double max_rate = -1e9;

	void run(double seconds, double network, double jitter) {
		std::uniform_real_distribution<double> extra(0.0, jitter);
		double arrival = media + 0.05 + offset + network + extra(random);
		for (const double end = now + seconds; now < end;) {
			now += FRAME;
			while (arrival < now) {
				media += 0.05;
				if (!clock.is_running()) {
					clock.start(media, 0.1, now);
				}
				clock.set_limits(min_delay, max_delay);
				clock.observe(media, now);
				clock.observe_motion(media - 0.05, now);
				arrival = std::max(arrival, media + 0.05 + offset + network + extra(random));
			}
			const double before = clock.media_time();
			clock.advance(now);
			if (clock.is_running() && before != clock.media_time()) {
				min_rate = std::min(min_rate, (clock.media_time() - before) / FRAME);
				max_rate = std::max(max_rate, (clock.media_time() - before) / FRAME);
			}
		}
	}
};

} // namespace

TEST_CASE("recent extreme: it covers the current span and the one before") {
	RecentExtreme largest(1.0, 2.0);
	CHECK(largest.is_empty());
	largest.add(5.0, 0.0);
	largest.add(3.0, 1.0);
	CHECK(largest.value() == 5.0);
	largest.add(1.0, 2.5); // a new span: the previous one still counts
	CHECK(largest.value() == 5.0);
	largest.add(2.0, 5.0);
	CHECK(largest.value() == 2.0);
	RecentExtreme smallest(-1.0, 2.0);
	smallest.add(-1.0, 0.0);
	smallest.add(4.0, 0.5);
	CHECK(smallest.value() == -1.0);
}

TEST_CASE("playback clock: it does not advance before it is started") {
	PlaybackClock clock;
	clock.advance(5.0);
	CHECK_FALSE(clock.is_running());
	CHECK(clock.media_time() == 0.0);
	CHECK(clock.media_time_at(9.0) == 0.0);
	CHECK(clock.delay_at(9.0) == 0.0);
}

TEST_CASE("playback clock: it settles at the delay that the windows need, and never runs backwards") {
	for (const double jitter : { 0.0, 0.03, 0.1 }) {
		Stream stream;
		stream.max_delay = 0.4;
		stream.run(20.0, 0.08, jitter);
		CAPTURE(jitter);
		// From the begin of a window to its arrival: its length and the jitter, not the network's own delay.
		CHECK(stream.clock.target_delay() >= 0.05 + jitter * 0.7 - 1e-9);
		CHECK(stream.clock.target_delay() <= 0.05 + jitter + FRAME + 1e-9);
		CHECK(stream.clock.delay_at(stream.now) == doctest::Approx(stream.clock.target_delay()).epsilon(0.15));
		CHECK(stream.clock.jitter() <= jitter + FRAME + 1e-9);
		CHECK(stream.clock.jitter() >= jitter * 0.6);
		CHECK(stream.min_rate >= 0.6 - 1e-9);
		CHECK(stream.max_rate <= 1.15 + 1e-9);
		const double before = stream.clock.media_time();
		stream.clock.advance(stream.now - 5.0); // a clock that goes backwards
		CHECK(stream.clock.media_time() >= before);
	}
}

TEST_CASE("playback clock: limits hold, and the delay decreases again when the jitter ends") {
	Stream stream;
	stream.min_delay = 0.12;
	stream.run(10.0, 0.02, 0.0);
	CHECK(stream.clock.target_delay() == doctest::Approx(0.12));
	stream.run(10.0, 0.02, 0.5);
	CHECK(stream.clock.target_delay() == doctest::Approx(0.2));
	stream.min_delay = 0.0;
	stream.run(20.0, 0.02, 0.0);
	CHECK(stream.clock.target_delay() <= 0.05 + FRAME + 1e-9);
	CHECK(stream.clock.delay_at(stream.now) < 0.08);
	CHECK(stream.min_rate >= 0.6 - 1e-9);
}

TEST_CASE("playback clock: after silence it jumps ahead once, not back") {
	Stream stream;
	stream.run(5.0, 0.05, 0.01);
	stream.now += 5.0; // no frames and no arrivals, as when a machine was suspended
	stream.media += 5.0;
	const double before = stream.clock.media_time();
	stream.clock.observe(stream.media, stream.media + stream.offset + 0.05);
	stream.clock.advance(stream.now);
	CHECK(stream.clock.media_time() > before + 4.0);
	CHECK(stream.clock.media_time() < stream.now - stream.offset);
	stream.min_rate = 1e9;
	stream.run(3.0, 0.05, 0.01);
	CHECK(stream.min_rate >= 0.6 - 1e-9);
}

TEST_CASE("playback clock: media_time_at changes nothing and agrees with advance") {
	Stream stream;
	stream.run(3.0, 0.05, 0.02);
	const double there = stream.clock.media_time_at(stream.now + FRAME);
	CHECK(stream.clock.media_time_at(stream.now + FRAME) == there);
	CHECK(there > stream.clock.media_time());
	stream.clock.advance(stream.now + FRAME);
	CHECK(stream.clock.media_time() == doctest::Approx(there).epsilon(1e-12));
}
