#include "net/delivery/playback_clock.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace net;

namespace {

constexpr double FRAME = 1.0 / 60.0;

/// A stream whose windows arrive `network` after their end, with jitter; frames of 1/60 s. Its sender may run slow or stop.
struct Stream {
	PlaybackClock clock;
	double window = 0.05;
	double min_delay = 0.0;
	double max_delay = 0.2;
	double sender_rate = 1.0; // media seconds per second
	std::mt19937 random{ 5 };
	double sent = 1000.0; // local time at which the last window ended
	double arrival = 0.0; // of the next window
	double media = 0.0; // of the last arrival
	double first = 0.0; // media time at which playback starts
	double now = 1000.0;
	double min_rate = 1e9;
	double max_rate = -1e9;
	double max_step_back = 0.0; // of what is shown
	int frames = 0;
	int frozen = 0; // frames that show less than a tenth of the motion that the sender makes in that time

	[[nodiscard]] double shown() const { return std::min(clock.media_time(), media); }

	void schedule(double network, double jitter) {
		std::uniform_real_distribution<double> extra(0.0, jitter);
		sent += window / sender_rate;
		arrival = std::max(arrival, sent + network + extra(random));
	}

	/// The sender stands still for `seconds`.
	void hold(double seconds) {
		sent += seconds;
		arrival += seconds;
	}

	void run(double seconds, double network, double jitter) {
		if (arrival == 0.0) {
			schedule(network, jitter);
		}
		min_rate = 1e9;
		max_rate = -1e9;
		frames = frozen = 0;
		for (const double end = now + seconds; now < end;) {
			now += FRAME;
			const double shown_before = shown();
			const double before = clock.media_time();
			const bool has_begun = clock.is_running() && before > first;
			while (arrival < now) {
				media += window;
				if (!clock.is_running()) {
					first = media;
					clock.start(media, 0.1, now);
				}
				clock.set_limits(min_delay, max_delay);
				clock.observe_packet(now);
				clock.observe(media - window, media, now);
				schedule(network, jitter);
			}
			clock.advance(now);
			if (has_begun) { // before that, playback waits at the first known motion
				min_rate = std::min(min_rate, (clock.media_time() - before) / FRAME);
				max_rate = std::max(max_rate, (clock.media_time() - before) / FRAME);
				max_step_back = std::max(max_step_back, shown_before - shown());
				++frames;
				frozen += shown() - shown_before < 0.1 * sender_rate * FRAME ? 1 : 0;
			}
		}
	}
};

} // namespace

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
	const double before = stream.clock.media_time();
	stream.now += 5.0; // no frames: as when a machine was suspended
	stream.run(3.0 * FRAME, 0.05, 0.01); // everything arrives at once
	CHECK(stream.clock.media_time() > before + 4.0);
	CHECK(stream.clock.media_time() < stream.now - 1000.0);
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

TEST_CASE("playback clock: after the sender stood still, playback is smooth within 0.5 s and at its delay within 2 s") {
	for (const double window : { 0.05, 0.1, 0.18 }) {
		for (const double seconds : { 0.2, 0.35, 0.5, 1.0, 3.0, 10.0, 60.0 }) {
			CAPTURE(window);
			CAPTURE(seconds);
			Stream stream;
			stream.window = window;
			stream.max_delay = 0.4;
			stream.run(2.0, 0.02, 0.0);
			stream.run(8.0, 0.02, 0.0);
			const double delay = stream.clock.delay_at(stream.now);
			CHECK(stream.frozen == 0);
			stream.hold(seconds);
			stream.run(seconds, 0.02, 0.0);
			stream.run(0.5, 0.02, 0.0);
			stream.run(1.5, 0.02, 0.0);
			CHECK(stream.frozen <= stream.frames / 50);
			CHECK(stream.clock.delay_at(stream.now) == doctest::Approx(delay).epsilon(0.1));
			stream.run(5.0, 0.02, 0.0);
			CHECK(stream.frozen == 0);
			CHECK(stream.max_step_back < FRAME);
		}
	}
}

TEST_CASE("playback clock: while nothing arrives, the reported delay grows") {
	Stream stream;
	stream.run(5.0, 0.02, 0.0);
	stream.hold(10.0);
	stream.run(9.0, 0.02, 0.0);
	CHECK(stream.clock.delay_at(stream.now) > 8.9);
}

TEST_CASE("playback clock: a slow or fast sender plays smoothly at its own rate") {
	for (const double window : { 0.05, 0.1, 0.18 }) {
		for (const double rate : { 1.1, 0.98, 0.95, 0.9, 0.67, 0.4 }) {
			for (const double jitter : { 0.0, 0.02 }) {
				CAPTURE(window);
				CAPTURE(rate);
				CAPTURE(jitter);
				Stream stream;
				stream.window = window;
				stream.max_delay = 0.4;
				stream.run(10.0, 0.02, jitter);
				stream.sender_rate = rate;
				stream.run(3.0, 0.02, jitter); // it adapts
				stream.run(5.0, 0.02, jitter);
				CHECK(stream.frozen <= stream.frames / 50);
				CHECK(stream.min_rate > 0.75 * rate);
				CHECK(stream.max_rate < 1.25 * rate);
				CHECK(stream.clock.sender_rate() == doctest::Approx(rate).epsilon(0.05));
				stream.sender_rate = 1.0;
				stream.run(3.0, 0.02, jitter);
				stream.run(3.0, 0.02, jitter);
				CHECK(stream.frozen <= stream.frames / 50);
			}
		}
	}
}
