#include "stream_timing.hpp"

#include "../../../harness/allocation_counter.hpp"
#include "../../cpu_clock.hpp"

#include "net/endpoint/receiver.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace bench {

namespace {

constexpr uint32_t RECEIVER = 1;
// Seconds after which buffers have reached their sizes.
constexpr double WARM_UP = 2.0;

// Counted after the warm-up.
struct Counts {
	uint64_t allocations = 0;
	uint64_t packets = 0;
};

// A run of one end.
struct EndRun {
	double seconds = 0.0;
	uint64_t poses = 0;
	uint64_t bytes = 0;
	Counts counts;
};

EndRun run_sender(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const StreamRecording &acks) {
	EndRun run;
	net::Sender sender(settings);
	sender.add_receiver(RECEIVER, trace.begin());
	const double begin = cpu_seconds();
	for (size_t i = 0; i < acks.steps().size(); ++i) {
		const StreamRecording::Step &received = acks.steps()[i];
		const uint64_t before = harness::allocation_count();
		for (size_t datagram = received.begin; datagram < received.end; ++datagram) {
			(void)sender.accept(RECEIVER, acks.bytes(datagram), acks.size(datagram), received.time);
		}
		const SourceStep &step = feed.steps()[i];
		(void)feed.feed(sender, step);
		run.poses += step.end - step.begin;
		for (const net::OutgoingPacket &packet : sender.packets()) {
			run.bytes += packet.size;
		}
		if (step.time > trace.begin() + WARM_UP && step.time <= trace.end()) {
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
	std::vector<uint8_t> ack;
	ack.reserve(net::StreamSettings().max_packet_size);
	const double warm_up_end = packets.steps().front().time + WARM_UP;
	const double trace_end = packets.steps().front().time + trace.duration();
	const double begin = cpu_seconds();
	for (const StreamRecording::Step &received : packets.steps()) {
		const uint64_t before = harness::allocation_count();
		for (size_t datagram = received.begin; datagram < received.end; ++datagram) {
			(void)receiver.accept(packets.bytes(datagram), packets.size(datagram), received.time);
		}
		receiver.advance(received.time);
		for (const TraceBody &body : trace.bodies) {
			run.poses += receiver.pose(body.id) ? 1 : 0;
		}
		receiver.take_ack(ack, received.time);
		if (received.time > warm_up_end && received.time <= trace_end) {
			run.counts.allocations += harness::allocation_count() - before;
			run.counts.packets += received.end - received.begin;
		}
	}
	run.seconds = cpu_seconds() - begin;
	return run;
}

double per(double total, uint64_t count) {
	return count > 0 ? total / double(count) : std::numeric_limits<double>::quiet_NaN();
}

// The run with the median processor time.
template <class Run>
EndRun median_of_three(Run &&run) {
	std::array<EndRun, 3> runs = { run(), run(), run() };
	std::sort(runs.begin(), runs.end(), [](const EndRun &a, const EndRun &b) { return a.seconds < b.seconds; });
	return runs[1];
}

} // namespace

StreamTiming time_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const StreamResult &recorded) {
	const EndRun sender = median_of_three([&] { return run_sender(trace, feed, settings, recorded.acks); });
	const EndRun receiver = median_of_three([&] { return run_receiver(trace, recorded.packets); });
	StreamTiming timing;
	timing.encode = per(sender.seconds, sender.poses);
	timing.decode = per(receiver.seconds, receiver.poses);
	timing.sender_allocations = per(double(sender.counts.allocations), sender.counts.packets);
	timing.receiver_allocations = per(double(receiver.counts.allocations), receiver.counts.packets);
	timing.is_deterministic = sender.bytes == recorded.bytes_sent;
	return timing;
}

} // namespace bench
