#include "../../harness/allocation_counter.hpp"
#include "net/stream/snapshot_header.hpp"
#include "net/stream/stream_encoder.hpp"
#include "session_network.hpp"

// Streams of many bodies, and the memory that a peer can make a session use.

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

/// A snapshot of `count` bodies at rest, with its header.
Bytes snapshot_of(uint32_t count) {
	StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
	for (uint32_t id = 0; id < count; ++id) {
		REQUIRE(encoder.add_body(id, 0.0, PoseD()));
	}
	Bytes window;
	encoder.encode_window(0.0, 1, window);
	SnapshotHeader header;
	header.tick = 1;
	Bytes bytes;
	put_snapshot_header(bytes, header);
	encoder.encode_snapshot(bytes);
	return bytes;
}

/// Peer 1 sends the snapshot to peer 2, in the stream that peer 2 requested last.
void inject_snapshot(SessionNetwork &network, const Bytes &bytes, uint8_t number) {
	const uint8_t link = network.requested_link(2, 1);
	Snapshot snapshot;
	snapshot.bytes = bytes;
	for (size_t i = 0; i < snapshot.fragment_count(); ++i) {
		const size_t begin = i * snapshot.fragment_size;
		Bytes packet;
		put_fragment(packet, { number, 0, uint16_t(i), uint16_t(snapshot.fragment_count()), bytes.data() + begin, std::min(snapshot.fragment_size, bytes.size() - begin) });
		network.inject(1, 2, make_packet(PacketKind::MOTION, link, packet));
	}
}

} // namespace

TEST_CASE("session: a peer that knows few bodies of a stream shows them, however many there are") {
	for (const uint32_t count : { 1000u, 5000u }) {
		SessionNetwork network;
		network.join(1);
		network.join(2);
		for (uint32_t body = 0; body < count; ++body) {
			network.paths[body] = body % 100 == 0 ? smooth_path(body) : Path([body](double) { return turned_at(Vector3D(double(body), 0.0, 0.0), Vector3D(0.0, 1.0, 0.0), 0.0); });
			network.set_owner(1, body, 1);
			if (body % (count / 10) == 0) {
				network.set_owner(2, body, 1);
			}
		}
		network.run(1.0);
		CAPTURE(count);
		REQUIRE(network.is_streaming(1, 2));
		CHECK(network.session(2).stream_size(1) == count);
		double worst = 0.0;
		network.run(0.5, [&] {
			for (uint32_t body = 0; body < count; body += count / 10) {
				worst = std::max(worst, network.error(body, 2));
			}
		});
		CHECK(worst <= 1.3);
		CHECK(network.total(2).rejected == 0);
		CHECK(network.packets(2, 1, PacketKind::OPEN).size() <= 6);
	}
}

TEST_CASE("session: a stream of more than MAX_BODIES bodies is refused with its size, and requested again with back-off") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	network.run(0.5);
	CHECK(network.session(2).stream_size(1) == 0);
	const Bytes too_large = snapshot_of(uint32_t(Session::MAX_BODIES) + 3);
	const size_t before = harness::live_bytes();
	double pause = 0.25;
	uint8_t number = 0;
	for (int i = 0; i < 10; ++i) {
		const double refused = network.now;
		inject_snapshot(network, too_large, ++number);
		CHECK(network.session(2).stream_size(1) == Session::MAX_BODIES + 3);
		CHECK_FALSE(network.is_streaming(1, 2));
		network.run(pause - 2.0 * network.tick);
		CHECK(network.packets(2, 1, PacketKind::CLOSE, refused - 1e-6).size() == 1);
		CHECK(network.packets(2, 1, PacketKind::OPEN, refused + 1e-6).empty());
		network.run(4.0 * network.tick);
		REQUIRE(network.packets(2, 1, PacketKind::OPEN, refused + 1e-6).size() == 1);
		pause = std::min(2.0 * pause, 30.0);
	}
	CHECK(network.total(2).rejected == 10);
	REQUIRE_FALSE(network.peers[2].reports.empty());
	CHECK(network.peers[2].reports[0].second.error == PacketError::TOO_MANY_BODIES);
	CHECK(harness::live_bytes() < before + 200000);
	// The largest stream that is accepted.
	inject_snapshot(network, snapshot_of(uint32_t(Session::MAX_BODIES)), ++number);
	CHECK(network.is_streaming(1, 2));
	CHECK(network.session(2).stream_size(1) == Session::MAX_BODIES);
	CHECK(network.total(2).rejected == 10);
	const size_t with_bodies = harness::live_bytes();
	network.peers[2].session.connect(0);
	CHECK(with_bodies - harness::live_bytes() > 1000000);
	CHECK(harness::live_bytes() < before + 200000);
}

TEST_CASE("session: a few packets cannot make it allocate much") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	network.run(0.5);
	const uint8_t link = network.requested_link(2, 1);
	const size_t before = harness::live_bytes();
	for (uint8_t number = 0; number < 200; ++number) {
		const uint16_t count = 31000;
		const uint8_t byte = 1;
		Bytes packet;
		put_fragment(packet, { number, 0, uint16_t(count - 1 - number), count, &byte, 1 });
		network.inject(1, 2, make_packet(PacketKind::MOTION, link, packet));
	}
	CHECK(harness::live_bytes() < before + 50000);
	// A snapshot that declares as many bodies as its size allows.
	Bytes snapshot = snapshot_of(0);
	snapshot.resize(SnapshotHeader::MIN_BYTES);
	RangeEncoder coder(snapshot);
	uint32_t number = 1;
	coder.bits(number, 7);
	coder.bits(number, 32);
	MotionModels models;
	code_models(coder, models);
	number = 10000;
	coder.bits(number, INDEX_BITS);
	coder.finish();
	snapshot.resize(80000, 0);
	inject_snapshot(network, snapshot, 201);
	CHECK(harness::live_bytes() < before + 100 * snapshot.size());
}
