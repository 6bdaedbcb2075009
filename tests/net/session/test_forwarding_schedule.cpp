#include "net/session/forwarding_schedule.hpp"

#include "../motion_scenes.hpp"

#include <doctest/doctest.h>

using namespace net;

namespace {

constexpr double TICK = 1.0 / 60.0;

/// An owner whose windows arrive at a server that forwards each `period` seconds, and obeys its requests.
struct AlignedOwner {
	/// Lets `count` windows arrive. Returns how many requests were made.
	int run(int count) {
		int requests = 0;
		for (int i = 0; i < count; ++i) {
			now += period / divisor;
			const double arrival = now + phase + random.uniform(0.0, jitter);
			const double lead = std::ceil(arrival / period) * period - arrival;
			aligner.add_arrival(lead, period / divisor, arrival);
			last_lead = lead;
			if (const auto request = aligner.take_request(period, TICK, arrival)) {
				++requests;
				phase += request->shift;
				CHECK(request->period == period);
				CHECK(std::fabs(request->shift) <= 0.5 * period + 1e-9);
			}
		}
		return requests;
	}

	double period = 9 * TICK;
	double phase = 0.0;
	double jitter = 0.0;
	double divisor = 1.0; // windows per period
	double now = 100.0;
	double last_lead = 0.0;
	WindowAligner aligner;
	cga_test::Random random{ 7 };
};

} // namespace

TEST_CASE("forwarding schedule: owners are aligned by few requests, from any phase, also with jitter") {
	for (int step = 0; step < 9; ++step) {
		for (const double jitter : { 0.0, 0.005, 0.015 }) {
			AlignedOwner owner;
			owner.phase = step * TICK;
			owner.jitter = jitter;
			const int requests = owner.run(40);
			CAPTURE(step);
			CAPTURE(jitter);
			CHECK(requests <= (jitter == 0.0 ? 1 : 3));
			CHECK(owner.aligner.is_aligned());
			CHECK(owner.run(100) == 0);
			for (int i = 0; i < 50; ++i) {
				(void)owner.run(1);
				// A lead just below the period is that of a window that is slightly late.
				const double lead = std::remainder(owner.last_lead, owner.period);
				CHECK(lead >= -0.35 * TICK);
				CHECK(lead <= jitter + 1.1 * TICK);
			}
			CHECK(owner.aligner.max_lead() <= jitter + 1.1 * TICK);
		}
	}
}

TEST_CASE("forwarding schedule: owners with shorter windows divide the period") {
	AlignedOwner owner;
	owner.divisor = 2.0;
	owner.phase = 2.5 * TICK;
	CHECK(owner.run(40) <= 2);
	CHECK(owner.aligner.is_aligned());
	CHECK(std::fabs(std::remainder(owner.last_lead - 0.25 * TICK, 0.5 * owner.period)) <= 0.6 * TICK);
}

TEST_CASE("forwarding schedule: a late window changes nothing") {
	AlignedOwner owner;
	(void)owner.run(20);
	REQUIRE(owner.aligner.is_aligned());
	for (int i = 0; i < 20; ++i) {
		owner.aligner.add_arrival(5 * TICK, owner.period, owner.now);
		CHECK(owner.run(4) == 0);
	}
}

TEST_CASE("forwarding schedule: instants are whole ticks apart, within the owners' windows") {
	ForwardingSchedule schedule;
	for (const double max_window : { 0.183, 0.083, 0.05, 0.001, 10.0 }) {
		int64_t instants = 0;
		int64_t last = 0;
		for (int64_t tick = 0; tick < 600; ++tick) {
			schedule.begin_tick(tick, 5.0 + double(tick) * TICK, TICK, max_window);
			const double to_next = schedule.lead(5.0 + double(tick) * TICK);
			CHECK(to_next == doctest::Approx(schedule.period() - double(schedule.ticks_since_instant()) * TICK));
			CHECK(schedule.lead(5.0 + (double(tick) + 0.25) * TICK) == doctest::Approx(to_next - 0.25 * TICK));
			if (schedule.ticks_since_instant() == 0) {
				CHECK((instants == 0 || double(tick - last) * TICK == doctest::Approx(schedule.period())));
				CHECK_FALSE(schedule.holds(1.0, 5.0 + double(tick) * TICK));
				last = tick;
				++instants;
			}
		}
		CHECK(instants > 0);
		CHECK(schedule.period() <= std::max(max_window, TICK) + 1e-9);
		CHECK(schedule.period() <= 64 * TICK + 1e-9);
	}
}

TEST_CASE("forwarding schedule: windows that come early wait at most two ticks") {
	ForwardingSchedule schedule;
	int held = 0;
	int held_shortly = 0;
	for (int64_t tick = 0; tick < 10; ++tick) {
		schedule.begin_tick(tick, double(tick) * TICK, TICK, 10 * TICK);
		held += schedule.holds(1.0, double(tick) * TICK) ? 1 : 0;
		held_shortly += schedule.holds(0.0, double(tick) * TICK) ? 1 : 0;
		CHECK_FALSE(schedule.holds(1.0, double(tick + 1) * TICK)); // there was no tick
	}
	CHECK(held == 2);
	CHECK(held_shortly == 1);
}
