#include "net/session/session.hpp"

#include "session_network.hpp"

#include <doctest/doctest.h>

#include <algorithm>

// Peers of other versions are refused, and their version is reported.

using namespace net;
using namespace net_test;

namespace {

constexpr size_t OPEN_VERSION = ENVELOPE_BYTES + 1; // offset of the stream version in an OPEN

/// Three peers, each with a body. Peer `other` has another version: `change` turns packets of this version into its own and back.
template <class Change>
SessionNetwork network_with(PeerId other, bool relay, Change change) {
	SessionNetwork network;
	network.rewrite = [=](PeerId from, PeerId to, std::vector<uint8_t> &bytes) {
		if (from == other || to == other) {
			change(from == other, bytes);
		}
	};
	for (PeerId id = 1; id <= 3; ++id) {
		network.peers[id].session.set_relay(relay);
		network.join(id);
		network.paths[uint32_t(id)] = smooth_path(uint32_t(id));
	}
	for (PeerId id = 1; id <= 3; ++id) {
		network.set_owner(uint32_t(id), id);
	}
	return network;
}

/// Checks that peers of two versions have exchanged no motion, and that each has reported nothing but the other's version.
void check_refused(SessionNetwork &network, PeerId a, PeerId b, PacketError error, uint8_t version_of_b) {
	for (const auto &[at, of, version] : { std::tuple(a, b, version_of_b), std::tuple(b, a, uint8_t(255)) }) {
		int reports = 0;
		for (const auto &[from, report] : network.peers[at].reports) {
			if (from != of) {
				continue;
			}
			++reports;
			CHECK(report.error == error);
			if (at == a) {
				CHECK(report.version == version);
			}
		}
		CHECK(reports >= 1);
		CHECK_FALSE(network.is_streaming(of, at));
		CHECK(network.packets(of, at, PacketKind::MOTION).empty());
		CHECK(network.packets(of, at, PacketKind::OPEN).size() <= 12);
		CHECK(network.statistics(of, at).rejected == network.packets(of, at, PacketKind::OPEN).size());
	}
}

} // namespace

TEST_CASE("versions: a peer with another session version is refused on both sides") {
	for (const uint8_t version : { uint8_t(ENVELOPE_VERSION - 1), uint8_t(ENVELOPE_VERSION + 1), uint8_t(ENVELOPE_VERSION + 2) }) {
		for (const PeerId other : { 1, 2 }) { // the server and a client
			// To a peer with a higher version, ours is lower.
			const uint8_t seen = uint8_t((2 * ENVELOPE_VERSION - version) & 3);
			SessionNetwork network = network_with(other, false, [=](bool is_from, std::vector<uint8_t> &bytes) { bytes[0] = uint8_t((bytes[0] & ~0x0c) | (is_from ? version : seen) << 2); });
			network.run(20.0);
			CAPTURE(int(version));
			CAPTURE(other);
			for (PeerId id = 1; id <= 3; ++id) {
				if (id != other) {
					check_refused(network, id, other, PacketError::OTHER_SESSION_VERSION, version);
				}
			}
			CHECK(network.error(3, other == 1 ? 2 : 1) <= 1.3);
		}
	}
}

TEST_CASE("versions: a peer with another stream version is refused on both sides, with and without relaying") {
	for (const uint8_t version : { uint8_t(STREAM_VERSION - 1), uint8_t(STREAM_VERSION + 1), uint8_t(77) }) {
		for (const PeerId other : { 1, 2 }) {
			for (const bool relay : { false, true }) {
				SessionNetwork network = network_with(other, relay, [=](bool is_from, std::vector<uint8_t> &bytes) {
					if (read_envelope(bytes.data(), bytes.size())->kind == PacketKind::OPEN && bytes.size() > OPEN_VERSION) {
						bytes[OPEN_VERSION] = is_from ? version : uint8_t(STREAM_VERSION + 100);
					}
				});
				network.run(20.0);
				CAPTURE(int(version));
				CAPTURE(other);
				CAPTURE(relay);
				check_refused(network, 3 - other, other, PacketError::OTHER_STREAM_VERSION, version);
				if (other == 2 || !relay) {
					check_refused(network, other == 2 ? 1 : 3, other, PacketError::OTHER_STREAM_VERSION, version);
					CHECK(network.error(3, other == 1 ? 2 : 1) <= 1.3);
				}
			}
		}
	}
}

TEST_CASE("versions: a stream whose snapshot has another version is closed, and requested after growing pauses") {
	SessionNetwork network = network_of_two();
	network.run(1.0);
	const double begin = network.now;
	network.run(30.0, [&] {
		const std::vector<uint8_t> snapshot(40, STREAM_VERSION + 3); // the first byte is the version
		FragmentItem fragment;
		fragment.count = 1;
		fragment.bytes = snapshot.data();
		fragment.size = snapshot.size();
		std::vector<uint8_t> content;
		put_fragment(content, fragment);
		network.inject(2, 1, make_packet(PacketKind::MOTION, network.requested_link(1, 2), content));
	});
	int reports = 0;
	for (const auto &[from, report] : network.peers[1].reports) {
		if (report.error == PacketError::OTHER_STREAM_VERSION) {
			++reports;
			CHECK(report.version == STREAM_VERSION + 3);
		}
	}
	CHECK(reports >= 1);
	const size_t closes = network.packets(1, 2, PacketKind::CLOSE, begin).size();
	CHECK(closes >= 3);
	CHECK(closes <= 10);
	CHECK(network.packets(1, 2, PacketKind::OPEN, begin).size() <= 2 * closes + 2);
	CHECK(network.error(5, 2) <= 1.3);
}

TEST_CASE("versions: an OPEN without a version is accepted, a malformed one is rejected") {
	SessionNetwork network = network_of_two();
	network.run(0.5);
	const auto challenged = [&] {
		uint8_t link = 0;
		for (const SessionNetwork::SentPacket &packet : network.packets(1, 2, PacketKind::OPEN)) {
			link = packet.is_challenge() ? packet.envelope.link : link;
		}
		return link;
	};
	network.inject(2, 1, make_packet(PacketKind::OPEN, 200));
	network.run(0.5);
	CHECK(challenged() == 200);
	network.inject(2, 1, make_packet(PacketKind::OPEN, 201, { 8, STREAM_VERSION }));
	network.run(0.5);
	CHECK(challenged() == 200);
	REQUIRE(network.peers[1].reports.size() == 1);
	CHECK(network.peers[1].reports[0].second.error == PacketError::MALFORMED_OPEN);
}
