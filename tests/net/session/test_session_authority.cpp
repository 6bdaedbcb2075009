#include "net/session/session.hpp"

#include "session_network.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <string>

// What a peer cannot do to others: peers 1 (the server), 2 and 3 are honest, peer 4 is hostile.

using namespace net;
using namespace net_test;

namespace {

using Bytes = std::vector<uint8_t>;

constexpr PeerId SERVER = 1;
constexpr PeerId HOSTILE = 4;

/// Peer n owns body n.
SessionNetwork network_of_four(bool relay) {
	SessionNetwork network;
	for (PeerId id = 1; id <= HOSTILE; ++id) {
		network.peers[id].session.set_relay(relay);
		network.join(id);
	}
	for (PeerId id = 1; id <= HOSTILE; ++id) {
		network.paths[uint32_t(id)] = smooth_path(uint32_t(id));
		network.set_owner(uint32_t(id), id);
	}
	network.run(2.0);
	return network;
}

/// Packets and bytes from the server and the honest client 2 to the honest client 3, and the largest error of their bodies at 3.
struct Honest {
	size_t packets = 0;
	size_t bytes = 0;
	double error = 0.0;
	uint64_t rejected = 0;
};

/// Runs a network for 4 seconds in which peer 4 does `attack` each tick.
Honest measure(bool relay, const std::function<void(SessionNetwork &)> &attack) {
	SessionNetwork network = network_of_four(relay);
	Honest result;
	const double begin = network.now;
	network.run(4.0, [&] {
		if (attack) {
			attack(network);
		}
		for (const uint32_t body : { 1u, 2u }) {
			result.error = std::max(result.error, network.error(body, 3));
		}
	});
	for (const SessionNetwork::SentPacket &packet : network.sent) {
		if (packet.time > begin && packet.to == 3 && packet.from != HOSTILE) {
			++result.packets;
			result.bytes += packet.bytes.size();
		}
	}
	for (const PeerId at : { 1, 2, 3 }) {
		for (const PeerId of : { 1, 2, 3 }) {
			result.rejected += network.statistics(of, at).rejected;
		}
		const SessionStatistics hostile = network.statistics(HOSTILE, at);
		CHECK(network.total(at).rejected >= hostile.rejected);
	}
	return result;
}

/// The link of the last packet of a kind from a peer to another, or 0.
uint8_t link_of(const SessionNetwork &network, PeerId from, PeerId to, PacketKind kind) {
	const auto packets = network.packets(from, to, kind);
	return packets.empty() ? uint8_t(0) : packets.back().envelope.link;
}

/// The first packet of a stream: the snapshot of one body.
Bytes first_packet() {
	Sender sender(StreamSettings{});
	sender.add_receiver(1, 0.0, 0.0);
	sender.add_body(4, smooth_path(4)(0.0), false, 0.0);
	sender.flush(0.1, 0.1);
	REQUIRE(!sender.packets().empty());
	const auto &packet = sender.packets().front();
	return { sender.bytes() + packet.begin, sender.bytes() + packet.begin + packet.size };
}

/// Attacks on the authority of others. Each is repeated in every tick, at all honest peers.
struct Attack {
	std::string name;
	std::function<void(SessionNetwork &, PeerId at)> act;
};

const std::vector<Attack> &attacks() {
	static const std::vector<Attack> ALL = {
		{ "acknowledgements of the streams of others", [](SessionNetwork &network, PeerId at) {
			 for (const PeerId of : { 1, 2, 3 }) {
				 if (of != at) {
					 const auto acks = network.packets(of, at, PacketKind::ACK, network.now - 0.2);
					 if (!acks.empty()) {
						 network.inject(HOSTILE, at, acks.back().bytes);
					 }
					 network.inject(HOSTILE, at, make_packet(PacketKind::ACK, link_of(network, at, of, PacketKind::MOTION), { 0xc2 }));
				 }
			 }
		 } },
		{ "closing the streams of others", [](SessionNetwork &network, PeerId at) {
			 for (const PeerId of : { 1, 2, 3 }) {
				 if (of != at) {
					 network.inject(HOSTILE, at, make_packet(PacketKind::CLOSE, link_of(network, at, of, PacketKind::MOTION), { 0 }));
					 network.inject(HOSTILE, at, make_packet(PacketKind::CLOSE, link_of(network, of, at, PacketKind::MOTION), { 1 }));
				 }
			 }
		 } },
		{ "closing relayed channels", [](SessionNetwork &network, PeerId at) {
			 for (uint8_t channel = 0; channel < 5; ++channel) {
				 network.inject(HOSTILE, at, make_packet(PacketKind::CLOSE, link_of(network, SERVER, at, PacketKind::MOTION), { 1, channel, 0 }));
			 }
		 } },
		{ "motion on the links of others", [](SessionNetwork &network, PeerId at) {
			 for (const PeerId of : { 1, 2, 3 }) {
				 const auto motion = network.packets(of, at, PacketKind::MOTION, network.now - 0.2);
				 if (!motion.empty()) {
					 network.inject(HOSTILE, at, motion.back().bytes);
				 }
			 }
		 } },
		{ "claims to relay the streams of others", [](SessionNetwork &network, PeerId at) {
			 if (at == SERVER) {
				 return; // there, these are its own request and damaged packets of its own stream
			 }
			 network.inject(HOSTILE, at, make_packet(PacketKind::OPEN, uint8_t(7), { OPEN_RELAY, STREAM_VERSION }));
			 const uint8_t link = link_of(network, at, HOSTILE, PacketKind::OPEN);
			 for (const uint8_t owner : { 1, 2, 3 }) {
				 network.inject(HOSTILE, at, make_packet(PacketKind::MOTION, link, { uint8_t(1 << 2 | 2), owner, 0, 0, 0, 0xc0, 0, 0 }));
			 }
		 } },
		{ "every link", [](SessionNetwork &network, PeerId at) {
			 for (int link = 0; link < 256; ++link) {
				 network.inject(HOSTILE, at, make_packet(PacketKind::CLOSE, uint8_t(link), { uint8_t(link & 1) }));
				 network.inject(HOSTILE, at, make_packet(PacketKind::ACK, uint8_t(link), { 0xc2 }));
				 network.inject(HOSTILE, at, make_packet(PacketKind::MOTION, uint8_t(link), { 0xe1, 9, 0 }));
			 }
		 } },
		{ "requests to align windows", [](SessionNetwork &network, PeerId at) {
			 static uint8_t number = 0;
			 Bytes content;
			 put_alignment(content, { ++number, 0.1, 0.05 });
			 network.inject(HOSTILE, at, make_packet(PacketKind::ACK, link_of(network, at, HOSTILE, PacketKind::MOTION), content));
		 } },
		{ "OPEN and CLOSE", [](SessionNetwork &network, PeerId at) {
			 static uint8_t link = 0;
			 for (int i = 0; i < 20; ++i) {
				 network.request(HOSTILE, at, link, 0);
				 network.inject(HOSTILE, at, make_packet(PacketKind::CLOSE, link, { 0 }));
			 }
		 } },
		{ "streams that begin and end", [](SessionNetwork &network, PeerId at) {
			 uint8_t link = link_of(network, at, HOSTILE, PacketKind::OPEN);
			 for (int i = 0; i < 20; ++i) { // all peers of a process number their links in one sequence
				 network.inject(HOSTILE, at, make_packet(PacketKind::MOTION, link, first_packet()));
				 network.inject(HOSTILE, at, make_packet(PacketKind::CLOSE, link++, { 1 }));
			 }
		 } },
	};
	return ALL;
}

} // namespace

TEST_CASE("authority: no attack changes what honest peers see, or raises their traffic") {
	for (const bool relay : { false, true }) {
		const Honest undisturbed = measure(relay, nullptr);
		CHECK(undisturbed.error <= 1.3);
		for (const Attack &attack : attacks()) {
			const Honest attacked = measure(relay, [&](SessionNetwork &network) {
				for (const PeerId at : { 1, 2, 3 }) {
					attack.act(network, at);
				}
			});
			CAPTURE(relay);
			CAPTURE(attack.name);
			CHECK(attacked.error <= 1.3);
			CHECK(attacked.rejected == 0);
			CHECK(double(attacked.bytes) <= 1.15 * double(undisturbed.bytes));
			CHECK(double(attacked.packets) <= 1.15 * double(undisturbed.packets));
		}
	}
}

TEST_CASE("authority: a server and a relayed owner can name no other peer as the owner of a section") {
	SessionNetwork network = network_of_four(true);
	const uint8_t link = link_of(network, 3, SERVER, PacketKind::OPEN);
	for (const uint8_t owner : { 3, 1 }) { // the receiver itself, and the server
		const uint64_t before = network.statistics(SERVER, 3).rejected;
		network.inject(SERVER, 3, make_packet(PacketKind::MOTION, link, { uint8_t(9 << 2 | 2), owner, 0, 0, 0, 0xe1, 9, 0 }));
		CHECK(network.statistics(SERVER, 3).rejected == before + 1);
		CHECK(network.total(3).rejected == before + 1);
	}
	network.run(1.0);
	CHECK(network.error(2, 3) <= 1.3);
}

TEST_CASE("authority: the server does not relay bodies that it does not know, however they come and go") {
	for (const double period : { 0.0, 0.7, 1.9 }) { // seconds after which the bodies come or go; 0: they stay
		SessionNetwork network = network_of_four(true);
		const auto set_bodies = [&](bool exist) {
			for (uint32_t body = 100; body < 300; ++body) {
				network.paths[body] = smooth_path(body);
				if (exist) {
					network.set_owner(HOSTILE, body, HOSTILE);
				} else {
					network.peers[HOSTILE].owners.erase(body);
					network.session(HOSTILE).remove_body(body);
				}
			}
		};
		set_bodies(true);
		double changed = network.now;
		bool exist = true;
		size_t shown = 0;
		size_t steps = 0;
		network.run(20.0, [&] {
			if (period > 0.0 && network.now - changed > period) {
				changed = network.now;
				exist = !exist;
				set_bodies(exist);
			}
			const Receiver *stream = network.session(3).stream(HOSTILE);
			shown += stream != nullptr && stream->stream_size() > Relay::MAX_ABSENT && stream->known_time() > stream->media_time() ? 1 : 0;
			++steps;
		});
		CAPTURE(period);
		CHECK(double(shown) < 0.4 * double(steps));
		size_t reports = 0;
		for (const auto &[from, report] : network.peers[SERVER].reports) {
			CHECK(from == HOSTILE);
			CHECK(report.error == PacketError::ABSENT_BODIES);
			reports += size_t(report.count);
		}
		CHECK(reports >= 1);
		CHECK(network.total(SERVER).rejected == reports);
		CHECK(network.statistics(HOSTILE, SERVER).rejected == reports);
		CHECK(network.error(2, 3) <= 1.3);
	}
}

TEST_CASE("authority: the server relays a stream with as many unknown bodies as spawns and ends of an honest game cause") {
	SessionNetwork network = network_of_four(true);
	for (uint32_t body = 100; body < 100 + Relay::MAX_ABSENT; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(HOSTILE, body, HOSTILE);
	}
	network.run(4.0);
	CHECK(network.peers[SERVER].reports.empty());
	CHECK(network.error(HOSTILE, 3) <= 1.3);
}

TEST_CASE("authority: motion of bodies that the sender does not own is counted and not used") {
	for (const bool relay : { false, true }) {
		SessionNetwork network = network_of_four(relay);
		for (const uint32_t body : { 1u, 2u, 3u }) {
			network.set_owner(HOSTILE, body, HOSTILE);
		}
		network.run(2.0);
		CAPTURE(relay);
		for (const PeerId at : { 1, 2, 3 }) {
			CAPTURE(at);
			CHECK((relay && at != SERVER ? network.statistics(HOSTILE, at).unauthorized <= 3 : network.statistics(HOSTILE, at).unauthorized == 3));
			for (const uint32_t body : { 1u, 2u, 3u }) {
				CHECK((body == uint32_t(at) || network.error(body, at) <= 1.3));
			}
		}
	}
}

TEST_CASE("authority: bodies of clients in the server's own stream are counted and not used") {
	for (const bool relay : { false, true }) {
		SessionNetwork network = network_of_four(relay);
		for (const uint32_t body : { 2u, 3u }) {
			network.set_owner(SERVER, body, SERVER);
		}
		network.run(2.0);
		CAPTURE(relay);
		for (const PeerId at : { 2, 3, 4 }) {
			CAPTURE(at);
			CHECK(network.statistics(SERVER, at).unauthorized == 2);
			for (const uint32_t body : { 1u, 2u, 3u }) {
				// A server that relays can withhold the motion of clients, but not replace it in its own stream.
				CHECK((body == uint32_t(at) || (relay && body != 1) || network.error(body, at) <= 1.3));
			}
		}
	}
}

TEST_CASE("authority: only a server that relays aligns the windows of clients") {
	// The times of client 2's packets to `to`, if `from` requests another alignment in each tick.
	const auto times = [](bool relay, PeerId from, PeerId to) {
		SessionNetwork network = network_of_four(relay);
		const double begin = network.now;
		uint8_t number = 0;
		network.run(3.0, [&] {
			Bytes content;
			put_alignment(content, { ++number, 0.1, 0.03 });
			if (from != 0) {
				network.inject(from, 2, make_packet(PacketKind::ACK, link_of(network, 2, from, PacketKind::MOTION), content));
			}
		});
		std::vector<double> result;
		for (const auto &packet : network.packets(2, to, PacketKind::MOTION, begin)) {
			result.push_back(packet.time);
		}
		return result;
	};
	const std::vector<double> undisturbed = times(false, 0, 3);
	REQUIRE(undisturbed.size() > 8);
	CHECK(times(false, SERVER, 3) == undisturbed);
	CHECK(times(false, HOSTILE, 3) == undisturbed);
	CHECK(times(true, HOSTILE, SERVER) == times(true, 0, SERVER));
	CHECK(times(true, SERVER, SERVER) != times(true, 0, SERVER)); // the requests are well-formed
}

TEST_CASE("authority: a peer id that is given to another peer starts anew") {
	SessionNetwork network = network_of_two();
	network.set_owner(2, 6, 2);
	network.set_owner(1, 6, 2);
	network.paths[6] = smooth_path(6);
	for (int round = 0; round < 5; ++round) {
		network.run(1.0);
		CHECK(network.error(5, 2) <= 1.3);
		CHECK(network.error(6, 1) <= 1.3);
		// Packets of the old peer are still on their way to the new one.
		network.leave(2);
		network.join(2);
		network.set_owner(2, 5, 1);
		network.set_owner(2, 6, 2);
		network.run(1.0);
		CHECK(network.total(1).rejected <= uint64_t(round) + 1);
		CHECK(network.total(2).rejected <= 1);
	}
}

TEST_CASE("authority: packets of streams that never were are counted, however often the peer opens and closes its own") {
	for (const bool relay : { false, true }) {
		SessionNetwork network = network_of_four(relay);
		uint64_t forged = 0;
		uint8_t link = 0;
		network.run(4.0, [&] {
			network.inject(HOSTILE, SERVER, make_packet(PacketKind::OPEN, uint8_t(++link % 32), { relay ? OPEN_RELAY : uint8_t(0), STREAM_VERSION }));
			for (int other = 100; other < 120; ++other) {
				const bool is_own = other == link_of(network, SERVER, HOSTILE, PacketKind::OPEN) || other == link_of(network, HOSTILE, SERVER, PacketKind::OPEN);
				network.inject(HOSTILE, SERVER, make_packet(PacketKind::ACK, uint8_t(other), { 0xc2 }));
				forged += is_own ? 0 : 1;
			}
		});
		CAPTURE(relay);
		CHECK(network.statistics(HOSTILE, SERVER).rejected >= forged);
	}
}
