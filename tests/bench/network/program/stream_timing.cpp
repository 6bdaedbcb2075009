#include "stream_timing.hpp"

#include "../../../harness/allocation_counter.hpp"
#include "cpu_clock.hpp"

#include "net/receiver.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace bench {

namespace {

constexpr uint32_t RECEIVER = 1;
// Seconds after which memory has found its size.
constexpr double WARM = 2.0;

// Allocations, and what they are counted for, between two moments.
struct Counts {
	uint64_t allocations = 0;
	uint64_t packets = 0;
};

// One end's run.
struct EndRun {
	double seconds = 0.0;
	uint64_t poses = 0;
	uint64_t bytes = 0;
	Counts counts;
};

EndRun run_sender(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const StreamRecording &answers) {
	EndRun run;
	net::Sender sender(settings);
	sender.add_receiver(RECEIVER, trace.begin());
	const double begin = cpu_seconds();
	for (size_t i = 0; i < answers.steps().size(); ++i) {
		const StreamRecording::Datagrams &taken = answers.steps()[i];
		const uint64_t before = harness::allocation_count();
		for (size_t datagram = taken.begin; datagram < taken.end; ++datagram) {
			(void)sender.accept(RECEIVER, answers.bytes(datagram), answers.size(datagram), taken.time);
		}
		const SourceStep &step = feed.steps()[i];
		(void)feed.feed(sender, step);
		run.poses += step.end - step.begin;
		for (const net::OutgoingPacket &packet : sender.packets()) {
			run.bytes += packet.size;
		}
		if (step.time > trace.begin() + WARM && step.time <= trace.end()) {
			run.counts.allocations += harness::allocation_count() - before;
			run.counts.packets += sender.packets().size();
		}
	}
	run.seconds = cpu_seconds() - begin;
	return run;
}

EndRun run_receiver(const Trace &trace, const StreamRecording &packets) {
	EndRun run;
	if (packets.steps().empty()) {
		return run;
	}
	net::Receiver receiver;
	std::vector<uint8_t> answer;
	answer.reserve(net::MAX_PACKET_BYTES);
	cga::Pose<double> pose;
	const double warm = packets.steps().front().time + WARM;
	const double over = packets.steps().front().time + trace.duration();
	const double begin = cpu_seconds();
	for (const StreamRecording::Datagrams &taken : packets.steps()) {
		const uint64_t before = harness::allocation_count();
		for (size_t datagram = taken.begin; datagram < taken.end; ++datagram) {
			(void)receiver.accept(packets.bytes(datagram), packets.size(datagram), taken.time);
		}
		receiver.advance(taken.time);
		for (const TraceBody &body : trace.bodies) {
			run.poses += receiver.pose(body.id, pose);
		}
		(void)receiver.take_answer(answer, taken.time);
		if (taken.time > warm && taken.time <= over) {
			run.counts.allocations += harness::allocation_count() - before;
			run.counts.packets += taken.end - taken.begin;
		}
	}
	run.seconds = cpu_seconds() - begin;
	return run;
}

double per(double what, uint64_t count) {
	return count > 0 ? what / double(count) : std::numeric_limits<double>::quiet_NaN();
}

// The run of median length of three.
template <class Run>
EndRun median_of_three(Run &&run) {
	std::array<EndRun, 3> runs = { run(), run(), run() };
	std::sort(runs.begin(), runs.end(), [](const EndRun &a, const EndRun &b) { return a.seconds < b.seconds; });
	return runs[1];
}

} // namespace

StreamTiming time_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const StreamResult &recorded) {
	const EndRun sender = median_of_three([&] { return run_sender(trace, feed, settings, recorded.answers); });
	const EndRun receiver = median_of_three([&] { return run_receiver(trace, recorded.packets); });
	StreamTiming timing;
	timing.encode = per(sender.seconds, sender.poses);
	timing.decode = per(receiver.seconds, receiver.poses);
	timing.sender_allocations = per(double(sender.counts.allocations), sender.counts.packets);
	timing.receiver_allocations = per(double(receiver.counts.allocations), receiver.counts.packets);
	timing.repeats = sender.bytes == recorded.bytes_sent;
	return timing;
}

} // namespace bench
