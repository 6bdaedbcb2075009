#include "../../harness/allocation_counter.hpp"
#include "../hostile_stream.hpp"
#include "session_network.hpp"

#include <utility>

// Peers whose streams want too much memory or work, among honest ones.

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

/// A server (peer 1) and two clients. The peer `hostile` sends only what the test makes it send. The other client owns body 5, the
/// hostile peer body 6.
struct HostileNetwork {
	explicit HostileNetwork(PeerId hostile) :
			network({ 0.03 }), hostile(hostile), victim(hostile == 1 ? 2 : 1), honest(hostile == 1 ? 3 : 2) {
		for (const PeerId id : { 1, 2, 3 }) {
			network.join(id);
		}
		network.peers[hostile].blocked_until = 1e18;
		network.paths[5] = smooth_path(5);
		network.set_owner(5, honest);
		network.set_owner(6, hostile);
		run_frames(60, [] {});
	}

	template <class EachFrame>
	void run_frames(int count, EachFrame &&each) {
		for (int i = 0; i < count; ++i) {
			network.step();
			for (const SessionNetwork::SentPacket &packet : network.sent) {
				const bool is_to_hostile = packet.from == victim && packet.to == hostile;
				if (is_to_hostile && packet.envelope.kind == PacketKind::OPEN) {
					link = packet.envelope.link;
					opened_at.push_back(network.now);
				}
				closed += is_to_hostile && packet.envelope.kind == PacketKind::CLOSE ? 1 : 0;
			}
			network.sent.clear();
			each();
			max_bytes = std::max(max_bytes, harness::live_bytes());
		}
	}
	void send(const std::vector<Bytes> &packets) {
		for (const Bytes &packet : packets) {
			network.inject(hostile, victim, make_packet(PacketKind::MOTION, link, packet));
		}
	}
	[[nodiscard]] uint64_t reported(PacketError error) {
		uint64_t count = 0;
		for (const auto &report : network.peers[victim].reports) {
			CHECK(report.first == hostile);
			count += report.second.error == error ? 1 : 0;
		}
		return count;
	}

	SessionNetwork network;
	PeerId hostile;
	PeerId victim;
	PeerId honest;
	uint8_t link = 0; // of the stream that the victim requests
	std::vector<double> opened_at;
	int closed = 0; // CLOSE packets to the hostile peer
	size_t max_bytes = 0;
};

} // namespace

TEST_CASE("hostile peer: whole snapshots of new bodies in each tick cost bounded memory, then the stream, and nothing else") {
	constexpr uint32_t COUNT = 3000;
	for (const PeerId hostile : { 3, 1 }) {
		HostileNetwork test(hostile);
		const size_t before = harness::live_bytes();
		HostileStream stream(COUNT);
		double worst = 0.0;
		size_t sent = 0;
		test.run_frames(300, [&] {
			const std::vector<Bytes> packets = stream.snapshot();
			sent += packets.size() * 1100;
			test.send(packets);
			stream.replace_bodies(COUNT);
			stream.tick += 1.0;
			worst = std::max(worst, test.network.error(5, test.victim));
		});
		CAPTURE(hostile);
		CHECK(sent > 5000000);
		CHECK(test.max_bytes - before < 40000000);
		CHECK(worst <= 1.3);
		CHECK(test.reported(PacketError::TOO_MUCH_WORK) >= 1);
		CHECK(test.closed >= 1);
		CHECK(test.closed <= 5); // it is requested again after growing pauses
		CHECK(uint64_t(test.closed) == test.reported(PacketError::TOO_MUCH_WORK));
	}
}

TEST_CASE("hostile peer: streams that it closes and opens again share one budget") {
	constexpr uint32_t COUNT = 20000;
	HostileNetwork test(3);
	HostileStream stream(COUNT);
	const std::vector<Bytes> packets = stream.snapshot();
	constexpr size_t PACKETS_PER_FRAME = 20; // fewer than a flood
	size_t sent = 0;
	uint8_t link = test.link;
	int decoded = 0;
	double worst = 0.0;
	test.run_frames(300, [&] {
		sent = std::exchange(link, test.link) == link ? sent : 0;
		const size_t end = std::min(sent + PACKETS_PER_FRAME, packets.size());
		test.send({ packets.begin() + ptrdiff_t(sent), packets.begin() + ptrdiff_t(end) });
		sent = end;
		if (test.network.session(1).stream(3) != nullptr) {
			++decoded;
			test.network.inject(3, 1, make_packet(PacketKind::CLOSE, test.link, { uint8_t(CloseRole::SENDER) }));
		}
		worst = std::max(worst, test.network.error(5, 1));
	});
	const double snapshot_work = double(COUNT) * NEW_BODY_WORK;
	CHECK(decoded >= 2);
	CHECK(decoded <= 2 + int(5.0 * ReceiverBudget::work_rate(1) / snapshot_work));
	CHECK(worst <= 1.3);
}

TEST_CASE("hostile peer: packets of a stream that has not been requested yet create nothing") {
	HostileNetwork test(3);
	HostileStream stream(10);
	test.send(stream.snapshot());
	REQUIRE(test.network.session(1).stream(3) != nullptr);
	test.network.inject(3, 1, make_packet(PacketKind::CLOSE, test.link, { uint8_t(CloseRole::SENDER) }));
	const size_t before = harness::live_bytes();
	for (int i = 0; i < 256; ++i) { // one of them is the next link
		test.link = uint8_t(i);
		test.send(stream.snapshot());
	}
	CHECK(test.network.session(1).stream(3) == nullptr);
	CHECK(harness::live_bytes() < before + 1000);
	test.run_frames(60, [] {});
	test.send(stream.snapshot());
	CHECK(test.network.session(1).stream(3) != nullptr);
}

TEST_CASE("hostile peer: an owner of thousands of bodies is decoded without a wait, whether the server knows them or not") {
	for (const bool is_known : { true, false }) {
		SessionNetwork network({ 0.03 });
		network.join(1);
		network.join(2);
		for (uint32_t body = 0; body < 2000; ++body) {
			network.paths[body] = smooth_path(body);
			network.set_owner(2, body, 2);
			if (is_known || body == 7) {
				network.set_owner(1, body, 2);
			}
		}
		network.run(1.0);
		int waiting = 0;
		double worst = 0.0;
		network.run(1.0, [&] {
			waiting += network.session(1).stream(2)->budget().is_waiting() ? 1 : 0;
			worst = std::max(worst, network.error(7, 1));
		});
		CAPTURE(is_known);
		CHECK(waiting == 0);
		CHECK(worst <= 1.3);
		CHECK(network.total(1).rejected == 0);
	}
}

TEST_CASE("hostile peer: 10,000 packets a second are a flood, which costs neither decoding nor memory and is reported once") {
	HostileStream stream(4000);
	std::vector<Bytes> windows = stream.snapshot();
	for (int i = 0; i < 2000; ++i) {
		stream.add_window(1, windows);
	}
	HostileStream small(100);
	const std::vector<std::pair<PacketKind, std::vector<Bytes>>> kinds = { { PacketKind::MOTION, windows }, { PacketKind::MOTION, small.snapshot() }, { PacketKind::MOTION, { Bytes(1000, 0xff) } }, { PacketKind::ACK, { Bytes{ 0xc2 } } }, { PacketKind::ACK, { Bytes(8000, 0xc0) } }, { PacketKind::OPEN, { Bytes{} } }, { PacketKind::CLOSE, { Bytes{ 0 } } } };
	for (size_t kind = 0; kind < kinds.size(); ++kind) {
		CAPTURE(kind);
		HostileNetwork test(3);
		size_t next = 0;
		double worst = 0.0;
		uint64_t late_allocations = 0;
		const auto flood = [&](int frames, bool is_late) {
			test.run_frames(frames, [&] {
				for (int i = 0; i < 167; ++i) {
					const std::vector<Bytes> &packets = kinds[kind].second;
					const Bytes packet = make_packet(kinds[kind].first, test.link, packets[next++ % packets.size()]);
					const uint64_t made = harness::allocation_count();
					test.network.inject(3, 1, packet);
					late_allocations += is_late ? harness::allocation_count() - made : 0;
				}
				worst = std::max(worst, test.network.error(5, 1));
			});
		};
		flood(30, false);
		CHECK(test.network.session(1).stream(3) == nullptr);
		flood(120, true);
		CHECK(late_allocations == 0);
		CHECK(test.reported(PacketError::TOO_MANY_PACKETS) == 1);
		CHECK(test.network.total(1).rejected > 120 * 167);
		CHECK(test.network.session(1).stream(3) == nullptr);
		CHECK(worst <= 1.3);
		// After the flood, the stream is requested again and decoded.
		test.run_frames(300, [] {});
		HostileStream later(10);
		test.send(later.snapshot());
		CHECK(test.network.session(1).stream(3) != nullptr);
	}
}

TEST_CASE("hostile peer: a costly snapshot of a peer that owns one body waits for the end of the frame, and is not decoded in a flood") {
	HostileStream stream(4000);
	const std::vector<Bytes> snapshot = stream.snapshot();
	for (const bool is_flood : { false, true }) {
		CAPTURE(is_flood);
		HostileNetwork test(3);
		test.send(snapshot);
		CHECK(test.network.session(1).stream(3) == nullptr);
		for (int i = 0; i < (is_flood ? 167 : 0); ++i) {
			test.send({ Bytes{ 0xe1, 1, 0 } });
		}
		test.run_frames(1, [] {});
		CHECK((test.network.session(1).stream(3) == nullptr) == is_flood);
	}
}

TEST_CASE("hostile peer: the packets that have waited while the server stood still are no flood") {
	HostileNetwork test(3);
	HostileStream stream(1);
	std::vector<Bytes> packets = stream.snapshot();
	for (int i = 0; i < 600; ++i) { // 10 s
		std::vector<Bytes> window;
		stream.observe(1, true);
		stream.add_window(1, window);
		packets.push_back(window.at(0));
	}
	test.send(packets);
	test.run_frames(60, [] {});
	REQUIRE(test.network.session(1).stream(3) != nullptr);
	CHECK(test.network.session(1).stream(3)->known_time() >= 10.0);
	CHECK(test.network.total(1).rejected == 0);
	CHECK(test.closed == 0);
}
