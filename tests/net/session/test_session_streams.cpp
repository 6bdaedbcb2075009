#include "net/session/session.hpp"

#include "../../harness/allocation_counter.hpp"
#include "session_network.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>

// When streams are opened and closed.

using namespace net;
using namespace net_test;

namespace {

constexpr double ROUND_TRIP = 0.06;
constexpr double TICKS = 3.0 / 60.0; // processing at both ends

/// The distinct streams that a peer has sent to another.
size_t stream_count(const SessionNetwork &network, PeerId from, PeerId to, double since = -1e9) {
	std::set<uint8_t> links;
	for (const SessionNetwork::SentPacket &packet : network.packets(from, to, PacketKind::MOTION, since)) {
		links.insert(packet.envelope.link);
	}
	return links.size();
}

} // namespace

TEST_CASE("session: a stream opens whichever peer starts first") {
	for (const double viewer_first : { -1.0, 0.0, 1.0 }) { // seconds
		SessionNetwork network;
		network.paths[5] = smooth_path(5);
		const double both = network.now + std::abs(viewer_first);
		network.join(viewer_first > 0.0 ? 2 : 1);
		network.join(viewer_first > 0.0 ? 1 : 2);
		if (viewer_first >= 0.0) {
			network.set_owner(2, 5, 1);
		}
		if (viewer_first <= 0.0) {
			network.set_owner(1, 5, 1);
		}
		network.run(both - network.now);
		network.set_owner(5, 1);
		double ready_at = 1e9;
		network.run(2.0, [&] { ready_at = network.is_streaming(1, 2) ? std::min(ready_at, network.now) : ready_at; });
		CAPTURE(viewer_first);
		CHECK(ready_at - both <= 2.0 * ROUND_TRIP + TICKS);
		CHECK(network.error(5, 2) <= 1.3);
		CHECK(network.total(1).rejected + network.total(2).rejected == 0);
	}
}

TEST_CASE("session: OPEN is repeated with back-off until the stream arrives, and when it is silent") {
	SessionNetwork network = network_of_two();
	for (const auto &[from, to] : { std::pair(1, 2), std::pair(2, 1) }) {
		LinkSettings &settings = network.link(from, to).reliable.settings();
		settings.outage_begin = network.now;
		settings.outage_end = network.now + 13.0;
	}
	network.run(13.0);
	CHECK_FALSE(network.is_streaming(1, 2));
	const auto opens = network.packets(2, 1, PacketKind::OPEN);
	REQUIRE(opens.size() == 7);
	for (size_t i = 1; i < opens.size(); ++i) {
		const double pause = std::array{ 0.25, 0.5, 1.0, 2.0, 4.0, 4.0 }[i - 1];
		CHECK(opens[i].time - opens[i - 1].time >= pause - 1e-6);
		CHECK(opens[i].time - opens[i - 1].time <= pause + network.tick + 1e-6);
		CHECK(opens[i].envelope.link == opens[0].envelope.link);
		CHECK(opens[i].reliable);
	}
	network.run(4.0 + ROUND_TRIP + TICKS);
	CHECK(network.is_streaming(1, 2));
	const double ready = network.now;
	network.run(5.0);
	CHECK(network.packets(2, 1, PacketKind::OPEN, ready + network.tick / 2.0).empty());
	// After a second of silence the owner may have lost the subscription.
	LinkSettings &down = network.link(1, 2).unreliable.settings();
	down.outage_begin = network.now;
	down.outage_end = network.now + 3.0;
	const double silent = network.now;
	network.run(3.0);
	const auto repeated = network.packets(2, 1, PacketKind::OPEN, silent + network.tick / 2.0);
	REQUIRE(repeated.size() == 4);
	CHECK(repeated[0].time - silent >= 0.9);
	CHECK(repeated[0].time - silent <= 1.1);
	CHECK(repeated[0].envelope.link == opens[0].envelope.link);
	network.run(3.0);
	CHECK(network.error(5, 2) <= 1.3);
	CHECK(stream_count(network, 1, 2) == 1);
}

TEST_CASE("session: a stream opens under loss") {
	for (const double loss : { 0.3, 0.6 }) {
		SessionNetwork network = network_of_two({ 0.03, 0.02, loss });
		network.run(4.0);
		CAPTURE(loss);
		CHECK(network.is_streaming(1, 2));
		CHECK(stream_count(network, 1, 2) == 1);
	}
}

TEST_CASE("session: a peer that owns nothing remembers requests and costs next to nothing") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	network.run(10.0);
	CHECK_FALSE(network.session(1).is_sending());
	CHECK(network.packets(2, 1, PacketKind::OPEN).size() <= 11);
	CHECK(network.sent.size() == network.packets(1, 2, PacketKind::OPEN).size() + network.packets(2, 1, PacketKind::OPEN).size());
	const double before = network.now;
	network.run(60.0);
	CHECK(network.packets(2, 1, PacketKind::OPEN, before + 1e-6).size() <= 15);
	// It starts the stream in the tick in which it first owns a body, whatever the receiver knows of it.
	network.paths[5] = smooth_path(5);
	network.set_owner(1, 5, 1);
	CHECK(network.session(1).is_sending());
	const double owned = network.now;
	double ready_at = 1e9;
	network.run(1.0, [&] { ready_at = network.is_streaming(1, 2) ? std::min(ready_at, network.now) : ready_at; });
	CHECK(ready_at - owned <= 0.5 * ROUND_TRIP + TICKS);
	CHECK(network.total(1).rejected + network.total(2).rejected == 0);
}

TEST_CASE("session: a peer that does not know our request gets it again when it sends its own") {
	for (const double later : { 0.1, 0.9, 1.8, 3.0 }) { // seconds between the two sessions' starts
		SessionNetwork network;
		network.join(2);
		network.join(1);
		network.close_session(1); // connected, but without a session
		network.run(later);
		network.join(1);
		network.paths[5] = smooth_path(5);
		network.set_owner(5, 1);
		const double joined = network.now;
		double ready_at = 1e9;
		network.run(1.0, [&] { ready_at = network.is_streaming(1, 2) ? std::min(ready_at, network.now) : ready_at; });
		CAPTURE(later);
		CHECK(ready_at - joined <= 2.5 * ROUND_TRIP + TICKS);
		network.run(3.0);
		CHECK(network.packets(1, 2, PacketKind::OPEN, joined).size() <= 10);
		CHECK(network.packets(2, 1, PacketKind::OPEN, joined).size() <= 10);
		CHECK(network.total(1).rejected + network.total(2).rejected == 0);
	}
}

TEST_CASE("session: when a body changes its owner, its old stream is closed and the new one opened") {
	SessionNetwork network;
	for (PeerId id = 1; id <= 3; ++id) {
		network.join(id);
	}
	for (const uint32_t body : { 7u, 8u }) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, 1);
	}
	network.run(2.0);
	CHECK_FALSE(network.is_streaming(3, 2));
	network.set_owner(7, 3);
	network.run(1.5);
	CHECK(network.error(7, 2) <= 1.3);
	CHECK(network.error(7, 1) <= 1.3);
	CHECK(network.error(8, 2) <= 1.3);
	CHECK(stream_count(network, 1, 2) == 1); // it was not interrupted
	CHECK_FALSE(network.session(2).stream(1)->pose(7));
	const double changed = network.now;
	network.set_owner(8, 3);
	network.run(0.1);
	// The old stream continues until its last motion has been shown.
	CHECK(network.session(2).stream(1)->pose(8));
	network.run(1.5);
	CHECK_FALSE(network.session(2).stream(1)->pose(8));
	CHECK(network.error(8, 2) <= 1.3);
	CHECK(network.error(8, 1) <= 1.3);
	CHECK(network.packets(1, 2, PacketKind::CLOSE).empty());
	network.run(1.5);
	const auto closes = network.packets(1, 2, PacketKind::CLOSE);
	REQUIRE(closes.size() == 1);
	CHECK(closes[0].time - changed >= 2.0);
	CHECK(closes[0].reliable);
	CHECK(closes[0].bytes.back() == uint8_t(CloseRole::SENDER));
	CHECK_FALSE(network.is_streaming(1, 2));
	CHECK_FALSE(network.session(1).is_sending());
	// A body comes back: no request is needed.
	network.set_owner(7, 1);
	const double returned = network.now;
	double ready_at = 1e9;
	network.run(0.5, [&] { ready_at = network.is_streaming(1, 2) ? std::min(ready_at, network.now) : ready_at; });
	CHECK(ready_at - returned <= 0.5 * ROUND_TRIP + TICKS);
	for (PeerId id = 1; id <= 3; ++id) {
		CHECK(network.total(id).rejected == 0);
	}
	network.session(2).remove_body(9); // unknown
}

TEST_CASE("session: bodies that their sender does not own are counted, and the owner's poses are shown") {
	SessionNetwork network;
	for (PeerId id = 1; id <= 3; ++id) {
		network.join(id);
	}
	for (const uint32_t body : { 7u, 8u }) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, 3);
	}
	network.paths[6] = smooth_path(6);
	network.set_owner(6, 1);
	network.set_owner(1, 7, 1); // peer 1 takes two of peer 3's bodies
	network.set_owner(1, 8, 1);
	network.run(2.0);
	for (const uint32_t body : { 6u, 7u, 8u }) {
		CHECK(network.error(body, 2) <= 1.3);
	}
	CHECK(network.statistics(1, 2).unauthorized == 2);
	CHECK(network.statistics(3, 2).unauthorized == 0);
	CHECK(network.total(2).unauthorized == 2);
	CHECK(network.total(2).rejected == 0);
}

TEST_CASE("session: either peer closes a stream") {
	SessionNetwork network = network_of_two();
	network.run(1.0);
	REQUIRE(network.is_streaming(1, 2));
	network.close_session(1);
	REQUIRE(network.packets(1, 2, PacketKind::CLOSE).size() == 2); // one for each direction
	CHECK(network.packets(1, 2, PacketKind::CLOSE)[0].reliable);
	const double closed = network.now;
	network.run(0.03 + 2.0 * network.tick);
	CHECK_FALSE(network.is_streaming(1, 2));
	network.run(2.0);
	CHECK(network.packets(2, 1, PacketKind::OPEN, closed).size() >= 4); // the owner may return
	network.join(1);
	network.set_owner(1, 5, 1);
	network.run(1.0);
	CHECK(network.error(5, 2) <= 1.3);

	network.close_session(2);
	CHECK(network.packets(2, 1, PacketKind::CLOSE).size() == 1);
	network.run(0.03 + 2.0 * network.tick);
	CHECK_FALSE(network.session(1).is_sending());
	CHECK(network.total(1).rejected + network.total(2).rejected == 0);
	network.join(2);
	network.set_owner(2, 5, 1);
	network.run(1.0);
	CHECK(network.error(5, 2) <= 1.3);
	// CLOSE of another stream changes nothing.
	const uint8_t link = uint8_t(network.packets(1, 2, PacketKind::MOTION).back().envelope.link + 1);
	network.inject(1, 2, make_packet(PacketKind::CLOSE, link, { uint8_t(CloseRole::SENDER) }));
	network.inject(2, 1, make_packet(PacketKind::CLOSE, link, { uint8_t(CloseRole::RECEIVER) }));
	CHECK(network.is_streaming(1, 2));
	CHECK(network.session(1).is_sending());
}

TEST_CASE("session: packets in flight of an ended stream are not rejected for two seconds") {
	SessionNetwork network = network_of_two();
	network.run(1.0);
	const std::vector<uint8_t> motion = network.packets(1, 2, PacketKind::MOTION).back().bytes;
	const std::vector<uint8_t> ack = network.packets(2, 1, PacketKind::ACK).back().bytes;
	network.set_owner(5, 2);
	network.run(2.5);
	REQUIRE_FALSE(network.session(1).is_sending());
	for (const double wait : { 0.0, 1.7 }) {
		network.run(wait);
		network.inject(1, 2, motion);
		network.inject(2, 1, ack);
	}
	CHECK(network.total(1).rejected + network.total(2).rejected == 0);
	network.run(0.4);
	network.inject(1, 2, motion);
	network.inject(2, 1, ack);
	CHECK(network.total(2).rejected == 1);
	CHECK(network.total(1).rejected == 1);
	network.run(1.0);
	REQUIRE(network.peers[2].reports.size() == 1);
	CHECK(network.peers[2].reports[0].second.error == PacketError::STREAM_NOT_REQUESTED);
	REQUIRE(network.peers[1].reports.size() == 1);
	CHECK(network.peers[1].reports[0].second.error == PacketError::NOT_SUBSCRIBED);
}

TEST_CASE("session: a peer cannot make the owner start a stream more often than every 0.2 s") {
	for (const bool closes : { false, true }) {
		SessionNetwork network;
		network.join(1);
		network.join(2);
		network.paths[5] = smooth_path(5);
		network.set_owner(1, 5, 1);
		uint8_t link = 0;
		network.run(3.0, [&] {
			if (closes) {
				network.inject(2, 1, make_packet(PacketKind::CLOSE, link, { uint8_t(CloseRole::RECEIVER) }));
			}
			network.request(2, 1, link, 0);
		});
		CAPTURE(closes);
		CHECK(stream_count(network, 1, 2) <= 15);
		CHECK(stream_count(network, 1, 2) >= 3); // the requests of the peer's own session come between
		CHECK(network.total(1).rejected == 0);
	}
}

TEST_CASE("session: a peer that does not prove that it receives replies gets at most 4 bytes for each that it sends") {
	SessionNetwork network;
	network.join(1);
	network.join(2);
	network.close_session(2); // connected, but without a session
	for (uint32_t body = 0; body < 2000; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(1, body, 1);
	}
	network.run(10.0); // until requests of our own are rare
	const double from = network.now;
	size_t received = 0;
	uint8_t link = 100;
	network.run(3.0, [&] {
		// Each is a new request, or repeats one, or guesses the token.
		const std::vector<uint8_t> packet = link % 3 == 0 ? make_packet(PacketKind::OPEN, link, { OPEN_TOKEN, STREAM_VERSION, link, link }) : make_packet(PacketKind::OPEN, link % 3 == 1 ? link : 7);
		++link;
		received += packet.size();
		network.inject(2, 1, packet);
	});
	size_t sent = 0;
	for (const SessionNetwork::SentPacket &packet : network.sent) {
		sent += packet.from == 1 && packet.time > from ? packet.bytes.size() : 0;
	}
	CHECK(sent > 0);
	CHECK(sent <= 4 * received);
	CHECK(network.packets(1, 2, PacketKind::MOTION).empty());
}

TEST_CASE("session: set_peers() returns the peers that have left and frees their state") {
	SessionNetwork network;
	Session &session = network.join(1);
	network.join(2);
	network.join(3);
	for (const uint32_t body : { 5u, 6u }) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, body == 5 ? 1 : 2);
	}
	network.run(2.0);
	CHECK(session.has_peer(2));
	CHECK(session.peers() == std::vector<PeerId>{ 2, 3 });
	CHECK(network.statistics(2, 1).received_bytes > 0.0);
	CHECK(session.set_peers({ 2, 3 }, network.local(1)).empty());
	const size_t before = harness::live_bytes();
	CHECK(session.set_peers({ 3 }, network.local(1)) == std::vector<PeerId>{ 2 });
	CHECK(harness::live_bytes() + 10000 < before);
	CHECK_FALSE(session.has_peer(2));
	CHECK(session.stream(2) == nullptr);
	CHECK(network.statistics(2, 1).received_bytes == 0.0);
	CHECK(session.is_sending()); // to peer 3
	CHECK(session.set_peers({ 4 }, network.local(1)) == std::vector<PeerId>{ 3 });
	CHECK_FALSE(session.is_sending());
	CHECK(session.set_peers({}, network.local(1)) == std::vector<PeerId>{ 4 }); // no packet was exchanged with it
	const size_t sent = network.sent.size();
	network.run(0.5);
	CHECK(network.packets(1, 2, PacketKind::MOTION, network.now - 0.4).empty());
	CHECK(network.sent.size() > sent); // of the others
}

TEST_CASE("session: connect starts over without sending") {
	SessionNetwork network;
	Session &session = network.join(1);
	network.join(2);
	network.paths[5] = network.paths[6] = smooth_path(5);
	network.set_owner(5, 1);
	network.set_owner(6, 2);
	network.run(1.0);
	REQUIRE(session.is_sending());
	REQUIRE(session.stream(2) != nullptr);
	session.connect(7);
	CHECK(session.is_connected());
	CHECK(session.self() == 7);
	CHECK(session.peers().empty());
	CHECK_FALSE(session.is_sending());
	CHECK(session.stream(2) == nullptr);
	session.connect(0);
	CHECK_FALSE(session.is_connected());
	int count = 0;
	session.outbox().drain([&](const Outbox::Packet &, const uint8_t *) { ++count; });
	CHECK(count == 0);
}
