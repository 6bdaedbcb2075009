#include "net/delivery/delivery.hpp"

#include "ack_numbers.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace net;

namespace {

constexpr size_t MAX_PACKET = 1100;

/// A delivery, and the acknowledgements of its receiver.
struct Line {
	Line() {
		auto snapshot = std::make_shared<Snapshot>();
		snapshot->number = 3;
		snapshot->bytes.assign(3 * snapshot->fragment_size - 5, 1);
		delivery.start_snapshot(snapshot);
	}

	void push_window(size_t size = 10) { ring.push_window(std::vector<uint8_t>(size, 2), 0, 0.05, MAX_PACKET, delivery.first_missing()); }

	/// The items of all packets that are sent at `time`.
	PacketContent send(double time) {
		PacketContent all;
		bytes.clear();
		packets = 0;
		std::vector<std::pair<size_t, size_t>> ranges;
		delivery.send(ring, time, MAX_PACKET, bytes, [&](size_t begin, size_t size) { ranges.emplace_back(begin, size); });
		for (const auto &[begin, size] : ranges) {
			++packets;
			PacketContent content;
			CHECK(size <= MAX_PACKET);
			REQUIRE(read_packet(bytes.data() + begin, size, content));
			all.chunks.insert(all.chunks.end(), content.chunks.begin(), content.chunks.end());
			all.fragments.insert(all.fragments.end(), content.fragments.begin(), content.fragments.end());
			all.round_trip = std::max(all.round_trip, content.round_trip);
		}
		return all;
	}

	void accept_ack(uint16_t next, const AckNumbers &later, double time) {
		PacketContent content;
		content.acks.push_back({ next, 0, ack_runs(later) });
		delivery.accept(content, ring, time);
	}

	void accept_snapshot_ack(uint8_t number, uint16_t next, const AckNumbers &later, double time) {
		PacketContent content;
		content.snapshot_acks.push_back({ number, next, ack_runs(later) });
		delivery.accept(content, ring, time);
	}

	/// Sends the snapshot; all of it arrives, and is acknowledged a round trip later.
	void finish_snapshot(double time, double round_trip = 0.1) {
		(void)send(time);
		accept_snapshot_ack(3, 3, {}, time + round_trip);
	}

	ChunkRing ring;
	Delivery delivery{ 0.0 };
	std::vector<uint8_t> bytes;
	int packets = 0;
};

} // namespace

TEST_CASE("delivery: fragments are retransmitted after a timeout until they have arrived") {
	Line line;
	CHECK(line.send(0.0).fragments.size() == 3);
	CHECK(line.packets == 3);
	CHECK(line.send(0.01).fragments.empty());
	CHECK(line.delivery.rto() == 0.2); // before the first measurement
	line.accept_snapshot_ack(3, 0, { 1 }, 0.05); // fragment 1
	line.accept_snapshot_ack(4, 3, {}, 0.05); // of another snapshot
	const PacketContent retransmitted = line.send(0.21);
	REQUIRE(retransmitted.fragments.size() == 2);
	CHECK(retransmitted.fragments[0].index == 0);
	CHECK(retransmitted.fragments[1].index == 2);
	CHECK(retransmitted.fragments[1].size == Snapshot().fragment_size - 5);
	CHECK(line.delivery.retransmissions() == 2);
	line.accept_snapshot_ack(3, 3, {}, 0.3);
	CHECK(line.send(1.0).fragments.empty());
}

TEST_CASE("delivery: chunks are sent once, and again if they are not acknowledged") {
	Line line;
	line.finish_snapshot(0.0);
	for (int i = 0; i < 3; ++i) {
		line.push_window();
	}
	PacketContent content = line.send(0.1);
	REQUIRE(content.chunks.size() == 3);
	CHECK(line.packets == 1);
	CHECK_FALSE(content.chunks[0].is_short); // only the last one of a packet can be short
	CHECK(content.chunks[2].is_short);
	line.accept_ack(0, { 2 }, 0.2); // chunk 2
	CHECK(line.delivery.round_trip() == doctest::Approx(0.1));
	CHECK(line.send(0.2).chunks.empty());
	content = line.send(0.1 + line.delivery.rto() + 1e-6);
	REQUIRE(content.chunks.size() == 2);
	CHECK(content.chunks[0].number == 0);
	CHECK(content.chunks[1].number == 1);
	CHECK_FALSE(content.chunks[1].is_short);
	CHECK(line.delivery.loss() == doctest::Approx(1.0 - std::pow(31.0 / 32.0, 2)));
	line.accept_ack(3, {}, 0.6);
	CHECK(line.send(2.0).chunks.empty());
	CHECK(line.delivery.round_trip() == doctest::Approx(0.1)); // retransmitted chunks give no sample
}

TEST_CASE("delivery: stale and invalid acknowledgements change nothing") {
	Line line;
	line.finish_snapshot(0.0, 0.05);
	line.push_window();
	line.push_window();
	(void)line.send(0.1);
	line.accept_ack(2, {}, 0.15);
	line.accept_ack(1, {}, 0.16); // an older one
	line.accept_ack(200, { 1, 2, 3 }, 0.16); // of chunks that were not sent
	line.push_window();
	const PacketContent content = line.send(0.2);
	REQUIRE(content.chunks.size() == 1);
	CHECK(content.chunks[0].number == 2);
	CHECK(content.chunks[0].is_short);
	CHECK(line.delivery.round_trip() == doctest::Approx(0.05));
}

TEST_CASE("delivery: a receiver that is stuck, far behind or requests it gets a snapshot, at most every half second") {
	Line stuck;
	stuck.finish_snapshot(0.0);
	CHECK_FALSE(stuck.delivery.needs_snapshot());
	stuck.push_window();
	double time = 0.0;
	for (; time < 10.0 && !stuck.delivery.needs_snapshot(); time += 1.0 / 60.0) {
		(void)stuck.send(time);
		stuck.accept_ack(0, {}, time); // it is not silent
	}
	CHECK(time > 1.5);
	CHECK(time < 7.0);

	// One that has been behind for longer than the ring keeps chunks.
	Line behind;
	behind.finish_snapshot(0.0);
	for (uint32_t i = 0; i <= ChunkRing::MAX_CHUNKS; ++i) {
		behind.push_window();
	}
	CHECK(behind.send(0.2).chunks.empty());
	CHECK(behind.delivery.needs_snapshot());
	CHECK(behind.send(0.3).chunks.empty()); // it waits for the snapshot

	Line requesting;
	PacketContent request;
	request.requests_snapshot = true;
	for (const double when : { 1.0, 1.4, 1.51 }) {
		requesting.finish_snapshot(when, 0.0);
		requesting.delivery.accept(request, requesting.ring, when);
		CHECK(requesting.delivery.needs_snapshot() == (when != 1.4));
		auto snapshot = std::make_shared<Snapshot>();
		snapshot->number = 3;
		snapshot->bytes.resize(10);
		requesting.delivery.start_snapshot(snapshot);
	}
}

TEST_CASE("delivery: a late receiver gets a snapshot only if that is smaller than what it lacks") {
	for (const size_t snapshot_size : { size_t(100), size_t(100000) }) {
		Line line;
		line.finish_snapshot(0.0);
		line.delivery.set_snapshot_size(snapshot_size);
		bool needed = false;
		for (double time = 0.1; time < 10.0; time += 1.0 / 60.0) {
			line.push_window(20);
			(void)line.send(time);
			line.accept_ack(0, {}, time); // it is not silent
			needed = needed || line.delivery.needs_snapshot();
		}
		CHECK(needed == (snapshot_size == 100));
	}
}

TEST_CASE("delivery: a request for a snapshot is ignored while one arrives") {
	Line line;
	PacketContent request;
	request.requests_snapshot = true;
	for (double time = 0.0; time < 5.0; time += 0.1) {
		(void)line.send(time);
		line.accept_snapshot_ack(3, uint16_t(time < 1.5 ? 1 : 2), {}, time);
		line.delivery.accept(request, line.ring, time);
		CHECK(line.delivery.needs_snapshot() == (time > 3.45)); // nothing has been acknowledged for 2 s
	}
}

TEST_CASE("delivery: what is sent at once exceeds the mean of the stream by 4 kB at most") {
	Line line;
	line.finish_snapshot(0.0);
	std::vector<size_t> sizes;
	for (int tick = 1; tick <= 600; ++tick) {
		const double time = 0.1 + tick / 60.0;
		if (tick % 4 == 0) {
			line.push_window(tick % 240 == 0 ? 90000 : 20000); // a window of many chunks, and now and then a far larger one
		}
		(void)line.send(time);
		sizes.push_back(line.bytes.size());
		line.accept_ack(uint16_t(line.delivery.unsent()), {}, time + 1.0 / 60.0);
	}
	double mean = 0.0;
	for (size_t i = 300; i < sizes.size(); ++i) {
		mean += double(sizes[i]) / double(sizes.size() - 300);
	}
	CHECK(mean > 5000.0);
	CHECK(double(*std::max_element(sizes.begin() + 300, sizes.end())) < 2.5 * mean + 4000.0);
	CHECK(line.delivery.retransmissions() == 0);
}

TEST_CASE("delivery: a silent receiver is only probed") {
	Line line;
	line.finish_snapshot(0.0, 0.0);
	line.push_window();
	int packets = 0;
	size_t bytes = 0;
	for (double time = Delivery::SILENCE + 0.01; time < 13.0; time += 1.0 / 60.0) {
		CHECK(line.delivery.is_silent(time));
		CHECK(line.send(time).chunks.empty());
		packets += line.packets;
		bytes += line.bytes.size();
	}
	CHECK(packets == 10);
	CHECK(bytes == 10 * ROUND_TRIP_BYTES);
	line.accept_ack(0, {}, 13.0);
	CHECK_FALSE(line.delivery.is_silent(13.0));
	CHECK(line.send(13.0).chunks.size() == 1);
}
