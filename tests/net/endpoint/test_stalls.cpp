#include "../simulated_session.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

namespace {

/// A hand that never rests.
PoseD hand(double t) {
	const Vector3D position(0.4 * std::sin(5.1 * t) + 0.1 * std::sin(11.3 * t), 0.3 * std::sin(4.3 * t + 2.0), 0.3 * std::cos(6.2 * t));
	return turned_at(position, Vector3D(std::sin(t), 1.0, std::cos(0.7 * t)), 1.2 * std::sin(4.7 * t));
}

struct Stalls {
	int windows = 0; // of 5 s
	int stalled = 0; // windows with a stall of more than 0.25 s
	double longest = 0.0; // in seconds
	double total = 0.0;
	double shown = 0.0; // seconds of playback
	double delay = 0.0; // mean
	double bytes = 0.0; // per second
};

/// Stalls of what is shown, after the first seconds, in runs with several seeds.
Stalls measure_stalls(const LinkSettings &link, double max_latency, int runs, uint32_t bodies = 1) {
	constexpr double WINDOW = 5.0;
	Stalls stalls;
	for (int run = 0; run < runs; ++run) {
		StreamSettings settings;
		settings.max_latency = max_latency;
		SimulatedSession session(settings);
		session.add_body(0, hand);
		for (uint32_t id = 1; id < bodies; ++id) { session.add_body(id, [id](double t) { PoseD p = hand(t + 0.37 * id); p.translation.x += id; return p; }); }
		RemoteEnd &end = session.add_receiver(uint32_t(run + 1), link);
		session.run(WINDOW);
		const uint64_t before = session.sender->statistics(uint32_t(run + 1)).bytes_sent;
		double still = 0.0;
		std::optional<PoseD> last = end.receiver->pose(0);
		for (int window = 0; window < 10; ++window) {
			double longest = 0.0;
			session.run(WINDOW, [&] {
				const std::optional<PoseD> pose = end.receiver->pose(0);
				const bool moves = pose && last && glm::length(pose->translation - last->translation) > 1e-9;
				still = moves ? 0.0 : still + SimulatedSession::TICK;
				longest = std::max(longest, still);
				stalls.total += moves ? 0.0 : SimulatedSession::TICK;
				stalls.delay += end.receiver->statistics().playback_delay * SimulatedSession::TICK;
				last = pose;
			});
			++stalls.windows;
			stalls.stalled += longest > 0.25 + 1e-6 ? 1 : 0;
			stalls.longest = std::max(longest, stalls.longest);
		}
		stalls.shown += 10 * WINDOW;
		stalls.bytes += double(session.sender->statistics(uint32_t(run + 1)).bytes_sent - before);
	}
	stalls.delay /= stalls.shown;
	stalls.bytes /= stalls.shown;
	return stalls;
}

} // namespace

TEST_CASE("stalls: at 30 % loss and 100 ms jitter, playback stalls for at most 0.25 s in 99 of 100 windows of 5 s") {
	for (const double delay : { 0.0, 0.03 }) {
		for (const double max_latency : { 0.1, 0.2 }) {
			const Stalls stalls = measure_stalls({ delay, 0.1, 0.3 }, max_latency, 40);
			CAPTURE(delay);
			CAPTURE(max_latency);
			CAPTURE(stalls.longest);
			CAPTURE(stalls.total / stalls.shown);
			CAPTURE(stalls.delay);
			CAPTURE(stalls.bytes);
			MESSAGE("stalled " << stalls.stalled << " of " << stalls.windows);
			CHECK(stalls.stalled * 100 <= stalls.windows);
		}
	}
}

TEST_CASE("stalls: copies are sent only at high loss") {
	const Stalls clean = measure_stalls({ 0.03 }, 0.2, 2);
	const Stalls lossy = measure_stalls({ 0.03, 0.03, 0.05 }, 0.2, 2);
	CAPTURE(clean.bytes);
	CAPTURE(lossy.bytes);
	CHECK(clean.total == 0.0);
	CHECK(lossy.longest <= 0.25);
	CHECK(lossy.bytes < 2.5 * clean.bytes);
}

TEST_CASE("variants") {
	struct V { const char *name; LinkSettings link; double latency; uint32_t bodies; };
	for (const V &v : { V{ "lat .05", { 0.0, 0.1, 0.3 }, 0.05, 1 }, V{ "delay .1", { 0.1, 0.1, 0.3 }, 0.2, 1 }, V{ "delay .1 lat .1", { 0.1, 0.1, 0.3 }, 0.1, 1 }, V{ "dup", { 0.0, 0.1, 0.3, 0.1 }, 0.2, 1 }, V{ "dup .3 lat .1", { 0.02, 0.1, 0.3, 0.3 }, 0.1, 1 }, V{ "40 bodies", { 0.0, 0.1, 0.3 }, 0.2, 40 }, V{ "40 bodies .1", { 0.0, 0.1, 0.3 }, 0.1, 40 }, V{ "200 bodies", { 0.0, 0.1, 0.3 }, 0.1, 200 }, V{ "20 %", { 0.0, 0.1, 0.2 }, 0.1, 1 }, V{ "15 %", { 0.0, 0.1, 0.15 }, 0.1, 1 }, V{ "10 %", { 0.0, 0.1, 0.1 }, 0.1, 1 }, V{ "5 %", { 0.0, 0.1, 0.05 }, 0.1, 1 }, V{ "40 %", { 0.0, 0.1, 0.4 }, 0.2, 1 }, V{ "burst", { 0.0, 0.1, 0.3, 0.0, 0.0, 0.0, 2.5 }, 0.2, 1 } }) {
		const Stalls s = measure_stalls(v.link, v.latency, v.bodies > 100 ? 4 : 20, v.bodies);
		MESSAGE(v.name << ": stalled " << s.stalled << "/" << s.windows << " longest " << s.longest << " share " << s.total / s.shown << " delay " << s.delay << " B/s " << s.bytes);
	}
}
