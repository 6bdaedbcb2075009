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
	double repeats = 0.0; // chunks sent again, per second
};

/// Stalls of what is shown, after the first seconds, in runs with several seeds.
Stalls measure_stalls(const LinkSettings &link, double max_latency, int runs) {
	constexpr double WINDOW = 5.0;
	Stalls stalls;
	for (int run = 0; run < runs; ++run) {
		StreamSettings settings;
		settings.max_latency = max_latency;
		SimulatedSession session(settings);
		session.add_body(0, hand);
		RemoteEnd &end = session.add_receiver(uint32_t(run + 1), link);
		session.run(WINDOW);
		const ReceiverStatistics before = session.sender->statistics(uint32_t(run + 1));
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
		const ReceiverStatistics after = session.sender->statistics(uint32_t(run + 1));
		stalls.bytes += double(after.bytes_sent - before.bytes_sent);
		stalls.repeats += double(after.chunks_repeated - before.chunks_repeated);
	}
	stalls.delay /= stalls.shown;
	stalls.bytes /= stalls.shown;
	stalls.repeats /= stalls.shown;
	return stalls;
}

} // namespace

TEST_CASE("stalls: with loss and 100 ms jitter, playback stalls for at most 0.25 s in 99 of 100 windows of 5 s") {
	struct Row {
		double loss;
		double delay;
		double max_latency;
		int runs;
	};
	for (const Row &row : { Row{ 0.3, 0.0, 0.1, 40 }, Row{ 0.3, 0.0, 0.2, 40 }, Row{ 0.3, 0.03, 0.1, 40 }, Row{ 0.3, 0.03, 0.2, 40 }, Row{ 0.3, 0.1, 0.2, 20 }, Row{ 0.2, 0.0, 0.1, 20 }, Row{ 0.1, 0.0, 0.1, 20 }, Row{ 0.05, 0.0, 0.1, 20 }, Row{ 0.02, 0.0, 0.1, 20 } }) {
		const Stalls stalls = measure_stalls({ row.delay, 0.1, row.loss }, row.max_latency, row.runs);
		CAPTURE(row.loss);
		CAPTURE(row.delay);
		CAPTURE(row.max_latency);
		CAPTURE(stalls.longest);
		CAPTURE(stalls.delay);
		CAPTURE(stalls.bytes);
		CHECK(stalls.stalled * 100 <= stalls.windows);
		CHECK(stalls.total <= 0.03 * stalls.shown);
	}
}

TEST_CASE("stalls: copies are sent only if a timeout would stall playback") {
	const Stalls clean = measure_stalls({ 0.03 }, 0.2, 2);
	const Stalls lossy = measure_stalls({ 0.03, 0.03, 0.05 }, 0.2, 2);
	CHECK(clean.total == 0.0);
	CHECK(lossy.longest <= 0.25);
	CHECK(lossy.bytes < 2.5 * clean.bytes);
	const Stalls jittery = measure_stalls({ 0.03, 0.1 }, 0.1, 4);
	CHECK(clean.repeats == 0.0);
	CHECK(lossy.repeats < 0.2 * 15.0); // of at most 15 windows per second
	CHECK(jittery.repeats < 0.05 * 20.0);
}
