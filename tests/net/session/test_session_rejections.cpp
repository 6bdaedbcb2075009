#include "net/session/session.hpp"

#include "../../harness/allocation_counter.hpp"
#include "session_network.hpp"

#include <doctest/doctest.h>

#include <cmath>

// What a session rejects, what it ignores, and what it reports.

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

/// Peer 1 owns body 5, peer 2 body 6; both streams are running.
SessionNetwork running_network() {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	for (const uint32_t body : { 5u, 6u }) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, body == 5 ? 1 : 2);
	}
	network.run(1.0);
	REQUIRE(network.is_streaming(1, 2));
	REQUIRE(network.is_streaming(2, 1));
	return network;
}

/// The error of the only packet that peer 1 rejects.
PacketError rejection_of(SessionNetwork &network, const Bytes &packet) {
	network.peers[1].reports.clear();
	const uint64_t before = network.total(1).rejected;
	network.inject(2, 1, packet);
	CHECK(network.total(1).rejected == before + 1);
	network.run(0.6);
	REQUIRE(network.peers[1].reports.size() == 1);
	CHECK(network.peers[1].reports[0].first == 2);
	CHECK(network.peers[1].reports[0].second.count == 1);
	return network.peers[1].reports[0].second.error;
}

} // namespace

TEST_CASE("session: each invalid packet is rejected with its error and changes nothing") {
	SessionNetwork network = running_network();
	const uint8_t link = network.packets(2, 1, PacketKind::MOTION).back().envelope.link;
	const uint8_t subscription = network.packets(1, 2, PacketKind::MOTION).back().envelope.link;
	for (const PacketKind kind : { PacketKind::OPEN, PacketKind::CLOSE, PacketKind::MOTION, PacketKind::ACK }) {
		Bytes other = make_packet(kind, link, { 0 });
		other[0] ^= 1 << 3;
		CHECK(rejection_of(network, other) == PacketError::OTHER_SESSION_VERSION);
	}
	CHECK(rejection_of(network, make_packet(PacketKind::CLOSE, link)) == PacketError::MALFORMED_CLOSE);
	CHECK(rejection_of(network, make_packet(PacketKind::CLOSE, link, { 1, 1 })) == PacketError::MALFORMED_CLOSE);
	CHECK(rejection_of(network, make_packet(PacketKind::CLOSE, link, { 2 })) == PacketError::MALFORMED_CLOSE);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, link)) == PacketError::EMPTY);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, link, { 0xe0, 1, 2 })) == PacketError::TRUNCATED);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, link, { 0xff })) == PacketError::UNKNOWN_ITEM);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, uint8_t(link + 1), { 0xff })) == PacketError::STREAM_NOT_REQUESTED);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, link, Bytes(StreamSettings::MAX_PACKET_SIZE + 1, 0xb0))) == PacketError::TOO_LONG);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, link, { 0xe0, 9, 0, 5, 0, 5, 0, 1, 0, 0 })) == PacketError::BAD_FRAGMENT);
	CHECK(rejection_of(network, make_packet(PacketKind::MOTION, link, { 0xe0, 9, 0, 0, 0, 0, 255, 255, 1, 0, 0 })) == PacketError::TOO_MANY_BODIES);
	CHECK(rejection_of(network, make_packet(PacketKind::ACK, subscription, { 0xc1, 0, 0, 0, 65 })) == PacketError::BAD_ACK);
	CHECK(rejection_of(network, make_packet(PacketKind::ACK, uint8_t(subscription + 1), { 0xc2 })) == PacketError::NOT_SUBSCRIBED);
	CHECK(network.error(6, 1) <= 1.3);
	CHECK(network.error(5, 2) <= 1.3);
	CHECK(network.total(2).rejected == 0);
	CHECK(network.packets(2, 1, PacketKind::OPEN).size() <= 2);
	CHECK(network.packets(1, 2, PacketKind::OPEN).size() <= 2);
}

TEST_CASE("session: packets of another session, of the game or of peers that are not connected are ignored") {
	SessionNetwork network = running_network();
	const Bytes motion = network.packets(2, 1, PacketKind::MOTION).back().bytes;
	const double bytes = network.statistics(2, 1).received_bytes;
	for (const uint8_t content : { 0, 2 }) {
		for (const PacketKind kind : { PacketKind::OPEN, PacketKind::CLOSE, PacketKind::MOTION, PacketKind::ACK }) {
			Bytes other_session = make_packet(kind, motion[3], Bytes(content, 0xff));
			++other_session[1];
			network.inject(2, 1, other_session);
			network.inject(3, 1, make_packet(kind, motion[3], Bytes(content, 0xff)));
		}
	}
	network.inject(2, 1, {});
	network.inject(2, 1, { 0x40, 1, 2 });
	network.inject(2, 1, Bytes(100, 0x80));
	network.run(0.5);
	CHECK(network.total(1).rejected == 0);
	CHECK(network.total(1).received_packets < 62.0);
	CHECK(network.statistics(2, 1).received_bytes < 1.5 * bytes);
	CHECK(network.packets(1, 3, PacketKind::MOTION).empty());
	CHECK(network.error(6, 1) <= 1.3);
	CHECK(network.is_streaming(1, 2));
}

TEST_CASE("session: rejections are counted per peer and in total, and reported at most twice a second") {
	SessionNetwork network = running_network();
	network.join(3);
	const Bytes bad = make_packet(PacketKind::CLOSE, 1);
	network.run(2.0, [&] {
		for (int i = 0; i < 5; ++i) {
			network.inject(2, 1, bad);
		}
		network.inject(3, 1, make_packet(PacketKind::MOTION, 1, { 0xff }));
	});
	const uint64_t ticks = network.total(1).rejected / 6;
	CHECK(ticks >= 119);
	CHECK(network.statistics(2, 1).rejected == 5 * ticks);
	CHECK(network.statistics(3, 1).rejected == ticks);
	network.run(1.0);
	uint64_t reported[4] = {};
	int reports[4] = {};
	for (const auto &[peer, report] : network.peers[1].reports) {
		reported[peer] += report.count;
		++reports[peer];
		CHECK(report.error == (peer == 2 ? PacketError::MALFORMED_CLOSE : PacketError::STREAM_NOT_REQUESTED));
	}
	CHECK(reported[2] == 5 * ticks);
	CHECK(reported[3] == ticks);
	for (const PeerId peer : { 2, 3 }) {
		CHECK(reports[peer] >= 4);
		CHECK(reports[peer] <= 6);
	}
	network.leave(2);
	CHECK(network.statistics(2, 1).rejected == 0);
	CHECK(network.total(1).rejected == 6 * ticks);
}

TEST_CASE("session: the callee of report_rejections() may change the session") {
	SessionNetwork network = running_network();
	network.inject(2, 1, make_packet(PacketKind::CLOSE, 1));
	int reports = 0;
	network.session(1).report_rejections([&](PeerId peer, const Rejections::Report &) {
		++reports;
		CHECK(peer == 2);
		network.session(1).connect(0);
	});
	CHECK(reports == 1);
}

TEST_CASE("session: statistics describe the traffic with each peer") {
	SessionNetwork network({ 0.03 });
	for (PeerId id = 1; id <= 3; ++id) {
		network.join(id);
	}
	for (uint32_t body = 0; body < 5; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, 1);
	}
	network.run(5.0);
	double bytes = 0.0;
	double packets = 0.0;
	for (const SessionNetwork::SentPacket &packet : network.sent) {
		const bool is_counted = packet.from == 1 && packet.to == 2 && packet.time > network.now - 1.05;
		bytes += is_counted ? double(packet.bytes.size()) : 0.0;
		packets += is_counted ? 1.0 : 0.0;
	}
	const SessionStatistics sent = network.statistics(2, 1);
	CHECK(sent.sent_bytes == doctest::Approx(bytes).epsilon(0.3));
	CHECK(sent.sent_packets == doctest::Approx(packets).epsilon(0.3));
	CHECK(sent.received_bytes > 0.0);
	CHECK(sent.received_packets > 0.0);
	CHECK(sent.round_trip >= 0.06);
	CHECK(sent.round_trip <= 0.1);
	CHECK(sent.loss < 0.05);
	const SessionStatistics received = network.statistics(1, 2);
	CHECK(received.received_bytes == doctest::Approx(sent.sent_bytes).epsilon(0.3));
	CHECK(received.received_packets == doctest::Approx(sent.sent_packets).epsilon(0.3));
	CHECK(received.round_trip == doctest::Approx(sent.round_trip).epsilon(0.3));
	CHECK(received.playback_delay > 0.05);
	CHECK(received.playback_delay < 0.25);
	CHECK(received.late == 0);
	const SessionStatistics total = network.total(1);
	CHECK(total.sent_bytes == sent.sent_bytes + network.statistics(3, 1).sent_bytes);
	CHECK(total.received_packets == sent.received_packets + network.statistics(3, 1).received_packets);
	CHECK(total.round_trip == std::max(sent.round_trip, network.statistics(3, 1).round_trip));
	CHECK(network.statistics(99, 1).sent_bytes == 0.0);
	network.link(1, 2).unreliable.settings().loss = 0.3;
	network.run(20.0);
	CHECK(network.statistics(2, 1).loss == doctest::Approx(0.3).epsilon(0.6));
	CHECK(network.statistics(1, 2).loss > 0.01); // it counts only chunks that arrive after newer ones
	// Late windows of streams that have ended stay counted.
	network.link(1, 2).unreliable.settings().loss = 0.0;
	network.run(2.0);
	const uint64_t late = network.total(2).late;
	for (uint32_t body = 0; body < 5; ++body) {
		network.set_owner(body, 2);
	}
	network.run(3.0);
	CHECK_FALSE(network.is_streaming(1, 2));
	CHECK(network.total(2).late == late);
	CHECK(network.statistics(1, 2).late == 0);
}

TEST_CASE("session: round trips are measured in less than a tick, at any frame rate") {
	for (const int frames : { 1, 4 }) {
		SessionNetwork network = network_of_two({ 0.045 });
		network.frames_per_tick = frames;
		network.run(4.0);
		CAPTURE(frames);
		CHECK(network.statistics(2, 1).round_trip >= 0.09);
		CHECK(network.statistics(2, 1).round_trip <= 0.09 + 2.0 / 60.0 / frames + 1e-3);
	}
}
