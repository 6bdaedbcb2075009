#include "../../harness/allocation_counter.hpp"
#include "../hostile_stream.hpp"
#include "net/endpoint/receiver.hpp"

#include <doctest/doctest.h>

#include <cmath>

// Streams that are coded as a sender codes them, but want too much memory or work.

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

/// A receiver that gets such a stream.
struct Victim {
	explicit Victim(size_t max_bodies, std::shared_ptr<WorkBudget> budget = nullptr) :
			receiver(max_bodies, std::move(budget)) {}

	void take(const std::vector<Bytes> &packets) {
		for (const Bytes &packet : packets) {
			const PacketResult result = receiver.accept(packet.data(), packet.size(), now);
			refusals += !result && result.error() == PacketError::TOO_MUCH_WORK ? 1 : 0;
			others += !result && result.error() != PacketError::TOO_MUCH_WORK ? 1 : 0;
		}
	}
	void check_memory() {
		const BodyTracks &tracks = receiver.tracks();
		CHECK(tracks.count() <= tracks.max_tracks());
		CHECK(tracks.capacity() <= tracks.max_capacity() + MotionTrack::MAX_CAPACITY + MotionTrack::MIN_CAPACITY * tracks.count());
	}

	Receiver receiver;
	double now = 10.0;
	int refusals = 0;
	int others = 0;
};

constexpr double FRAME_TIME = 1.0 / 60.0;

/// The work that a stream of `bodies` bodies may cause in `seconds`.
double allowed_work(size_t bodies, double seconds) {
	return ReceiverBudget::work_rate(bodies) * (seconds + ReceiverBudget::BURST);
}

} // namespace

TEST_CASE("hostile stream: whole snapshots of new bodies, one tick apart, cost bounded memory and work") {
	constexpr uint32_t COUNT = 2000;
	for (const bool advances : { false, true }) {
		const size_t before = harness::live_bytes();
		HostileStream stream(COUNT);
		Victim victim(COUNT);
		size_t max_bytes = 0;
		size_t bytes = 0;
		for (int i = 0; i < 300; ++i) {
			const std::vector<Bytes> packets = stream.snapshot();
			victim.take(packets);
			bytes += packets.size() * 1100;
			stream.replace_bodies(COUNT);
			stream.tick += 1.0;
			victim.now += FRAME_TIME;
			if (advances) {
				victim.receiver.advance(victim.now);
			}
			victim.check_memory();
			max_bytes = std::max(max_bytes, harness::live_bytes());
		}
		CAPTURE(advances);
		CHECK(bytes > 5000000);
		CHECK(max_bytes - before < 3000 * COUNT + 2000000); // including the stream's own
		const double snapshot_work = SNAPSHOT_WORK + COUNT * (NEW_BODY_WORK + 40.0);
		CHECK(victim.receiver.budget().total_work() <= allowed_work(COUNT, 5.0) + snapshot_work);
		CHECK(victim.receiver.snapshot_count() <= 4 + 4 * 5);
		CHECK(victim.refusals >= 1);
		CHECK(victim.refusals <= 5); // with growing pauses
		CHECK(victim.receiver.is_ready());
	}
}

TEST_CASE("hostile stream: snapshots that alternate between two lists of bodies") {
	constexpr uint32_t COUNT = 1000;
	HostileStream stream(COUNT);
	Victim victim(COUNT);
	std::vector<BodyEvent> events;
	for (int i = 0; i < 200; ++i) {
		stream.use_ids_from(i % 2 == 0 ? 0 : COUNT);
		stream.replace_bodies(COUNT);
		stream.tick += 1.0;
		victim.take(stream.snapshot());
		victim.now += 0.3;
		victim.check_memory();
	}
	CHECK(victim.receiver.snapshot_count() == 200); // slow enough to be decoded
	CHECK(victim.receiver.tracks().count() <= 2 * COUNT);
	victim.receiver.advance(victim.now + 1.0);
	victim.receiver.take_events(events);
	CHECK(events.size() <= 8 * COUNT + 65);
}

TEST_CASE("hostile stream: a body that is absent from snapshots costs nothing once it has ended") {
	HostileStream stream(10);
	Victim victim(10);
	for (int i = 0; i < 20; ++i) {
		victim.take(stream.snapshot());
		stream.tick += 1.0;
		if (i == 0) {
			stream.use_ids_from(100);
			stream.replace_bodies(10);
		}
		victim.now += 1.0;
	}
	REQUIRE(victim.receiver.snapshot_count() == 20);
	// The tracks of the first ten have their pose and one end.
	CHECK(victim.receiver.tracks().find(0)->capacity() == 2);
}

TEST_CASE("hostile stream: windows in which nothing moves cost no work for each body") {
	double works[2];
	for (const uint32_t count : { 600u, 60000u }) {
		HostileStream stream(count);
		Victim victim(count);
		victim.take(stream.snapshot());
		REQUIRE(victim.receiver.is_ready());
		victim.now += 10.0;
		std::vector<Bytes> packets;
		for (int i = 0; i < 100; ++i) {
			stream.add_window(1, packets);
		}
		CHECK(packets.size() <= 1);
		const double work = victim.receiver.budget().total_work();
		const uint64_t allocations = harness::allocation_count();
		victim.take(packets);
		victim.receiver.advance(victim.now);
		CHECK(harness::allocation_count() - allocations < 400);
		CHECK(victim.receiver.known_time() > 1.6);
		CHECK(victim.receiver.tracks().busy_count() == 0);
		works[count == 600 ? 0 : 1] = (victim.receiver.budget().total_work() - work) / 100.0;
	}
	CHECK(works[0] < 80.0);
	CHECK(works[1] < 400.0);
}

TEST_CASE("hostile stream: a snapshot that is begun anew with each fragment") {
	Victim victim(65536);
	const uint8_t bytes[10] = {};
	uint8_t number = 0;
	uint64_t allocations = 0;
	int rejected = 0;
	for (int i = 0; i < 300; ++i) {
		Bytes packet;
		for (int k = 0; k < 50; ++k) {
			put_fragment(packet, { ++number, 0, 8, 9, bytes, sizeof(bytes) });
		}
		victim.now += 0.0001;
		const uint64_t before = harness::allocation_count();
		rejected += victim.receiver.accept(packet.data(), packet.size(), victim.now) ? 0 : 1;
		allocations += harness::allocation_count() - before;
	}
	CHECK(allocations < 80); // those of a few snapshots
	CHECK(rejected == 1);
	CHECK(victim.receiver.is_refused());
	CHECK(victim.receiver.budget().total_work() < 1.0);
}

TEST_CASE("hostile stream: many segments of all bodies, which playback does not show") {
	constexpr uint32_t COUNT = 300;
	HostileStream stream(COUNT);
	Victim victim(COUNT);
	victim.take(stream.snapshot());
	for (int i = 0; i < 12; ++i) {
		std::vector<Bytes> packets;
		stream.observe(64, true);
		stream.add_window(64, packets);
		victim.now += 1.0;
		victim.take(packets);
		victim.check_memory();
	}
	CHECK(victim.receiver.known_time() > 12.0);
	// Without a limit, the motion of 12 s takes more.
	CHECK(victim.receiver.tracks().capacity() > 4000);
	CHECK(victim.refusals == 0);
	victim.receiver.advance(victim.now);
	victim.receiver.advance(victim.now + 5.0);
	CHECK(victim.receiver.tracks().capacity() <= 16 * COUNT);
}

TEST_CASE("hostile stream: all bodies are removed and as many others added in each window") {
	constexpr uint32_t COUNT = 500;
	HostileStream stream(COUNT);
	Victim victim(size_t(2) * COUNT);
	victim.take(stream.snapshot());
	for (int i = 0; i < 100; ++i) {
		std::vector<Bytes> packets;
		stream.exchange_bodies();
		stream.add_window(1, packets);
		victim.now += 0.5;
		victim.take(packets);
		victim.check_memory();
	}
	CHECK(victim.receiver.known_time() > 1.6); // it has decoded all of them
	CHECK(victim.receiver.stream_size() == COUNT);
	std::vector<BodyEvent> events;
	victim.receiver.take_events(events);
	CHECK(events.size() <= 8 * 2 * COUNT + 65);
}

TEST_CASE("hostile stream: media time that races ahead waits for playback") {
	HostileStream stream(3);
	Victim victim(10);
	victim.take(stream.snapshot());
	double ahead = 0.0;
	for (int i = 0; i < 600; ++i) {
		std::vector<Bytes> packets;
		for (int k = 0; k < 4; ++k) {
			stream.add_window(64, packets);
		}
		victim.take(packets);
		ahead = std::max(ahead, victim.receiver.known_time() - victim.receiver.media_time_at(victim.now));
		victim.now += 0.001;
	}
	CHECK(stream.tick / 60.0 > 2000.0);
	CHECK(ahead < 13.0);
}

TEST_CASE("hostile stream: after the last tick that a snapshot can name, the stream needs a new snapshot") {
	HostileStream stream(3);
	Victim victim(10);
	stream.tick = double(uint64_t(1) << (8 * SnapshotHeader::TICK_BYTES)) - 100.0;
	victim.take(stream.snapshot());
	REQUIRE(victim.receiver.is_ready());
	std::vector<Bytes> packets;
	for (int i = 0; i < 10; ++i) {
		stream.add_window(60, packets);
	}
	victim.take(packets);
	Bytes snapshot;
	victim.receiver.encode_snapshot(snapshot);
	const auto header = read_snapshot_header(snapshot.data(), snapshot.size());
	REQUIRE(header);
	CHECK(int64_t(header->tick) == std::llround(victim.receiver.known_time() * 60.0));
	Bytes ack;
	victim.now += 1.0;
	victim.receiver.take_ack(ack, victim.now);
	REQUIRE_FALSE(ack.empty());
	CHECK(ack[0] == 0xc2);
}

TEST_CASE("hostile stream: bodies at constant velocity in every tick are decoded as often as the budget allows, then refused") {
	constexpr uint32_t COUNT = 4000;
	HostileStream stream(COUNT);
	stream.settings.tick = 0.001;
	Victim victim(COUNT);
	victim.take(stream.snapshot());
	double before = 0.0;
	double seconds = 0.0;
	while (victim.refusals == 0 && seconds < 10.0) {
		std::vector<Bytes> packets;
		while (stream.tick - victim.receiver.known_time() / stream.settings.tick < 30.0) {
			stream.observe(1, false);
			stream.add_window(1, packets);
		}
		victim.take(packets);
		before = victim.receiver.budget().total_work();
		victim.now += FRAME_TIME;
		seconds += FRAME_TIME;
		victim.receiver.advance(victim.now);
	}
	CHECK(victim.refusals == 1);
	CHECK(seconds >= ReceiverBudget::MAX_WAIT);
	CHECK(before <= allowed_work(COUNT, seconds) + 1e6);
}

TEST_CASE("hostile stream: two streams that share a budget do not get more work done than one") {
	constexpr uint32_t COUNT = 5000;
	const auto budget = std::make_shared<WorkBudget>(1e6, 0.1);
	for (int i = 0; i < 20; ++i) { // each stream ends soon
		HostileStream stream(COUNT);
		Victim victim(COUNT, budget);
		victim.take(stream.snapshot());
		CHECK(victim.receiver.is_ready() == (i == 0));
	}
}

TEST_CASE("hostile stream: a refused stream is ignored for growing pauses, then requested again") {
	Victim victim(10);
	Bytes acks;
	for (int i = 0; i < 300; ++i) {
		put_ack(acks, {});
	}
	double pause = ReceiverBudget::FIRST_PAUSE;
	for (int refusal = 1; refusal <= 9; ++refusal) {
		while (victim.refusals < refusal) {
			victim.take({ acks });
		}
		const uint64_t rejected = victim.receiver.statistics().packets_rejected;
		const double refused = victim.now;
		victim.now = refused + 0.99 * pause;
		victim.take({ acks });
		CHECK(victim.receiver.is_refused());
		CHECK(victim.receiver.statistics().packets_rejected == rejected);
		Bytes packet;
		victim.receiver.take_ack(packet, victim.now);
		CHECK(packet.empty());
		victim.now = refused + 1.01 * pause;
		victim.take({ Bytes{ 0xe1, 1, 0 } });
		CHECK_FALSE(victim.receiver.is_refused());
		victim.receiver.take_ack(packet, victim.now);
		REQUIRE_FALSE(packet.empty());
		CHECK(packet[0] == 0xc2);
		pause = std::min(2.0 * pause, ReceiverBudget::MAX_PAUSE);
	}
	CHECK(victim.refusals == 9);
	CHECK(victim.others == 0);
	// The same receiver shows an ordinary stream.
	victim.now += 40.0;
	HostileStream stream(10);
	victim.take(stream.snapshot());
	CHECK(victim.receiver.is_ready());
	CHECK(victim.refusals == 9);
}

TEST_CASE("hostile stream: an unusual packet or window does not leave buffers allocated") {
	HostileStream stream(40, 60000);
	stream.settings.max_latency = 2.0;
	Victim victim(100);
	victim.take(stream.snapshot());
	victim.now += 1.0;
	std::vector<Bytes> packets;
	stream.observe(64, true);
	stream.add_window(64, packets);
	for (int i = 0; i < 8000; ++i) {
		put_ack(packets.back(), {});
	}
	const size_t before = harness::live_bytes();
	victim.take(packets);
	REQUIRE(victim.receiver.known_time() > 1.0);
	victim.take({ Bytes{ 0xe1, 1, 0 } });
	const size_t segments = victim.receiver.tracks().capacity();
	CHECK(segments > 1000);
	CHECK(harness::live_bytes() - before < segments * sizeof(BodyMotion) + 100000);
}
