#include "net/session/session.hpp"

#include "session_network.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace net;
using namespace net_test;

namespace {

constexpr PeerId SERVER = 1;

/// A server that relays and `count` clients, which own two bodies each, as does the server.
SessionNetwork network_of_owners(int count, const LinkSettings &link = { 0.03 }, bool is_star = true) {
	SessionNetwork network(link);
	network.is_star = is_star;
	for (PeerId id = 1; id <= count + 1; ++id) {
		network.peers[id].session.set_relay(true);
		network.join(id);
	}
	for (uint32_t body = 0; body < 2 * uint32_t(count + 1); ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, PeerId(body / 2) + 1);
	}
	return network;
}

/// The largest error of all bodies of other peers at a peer.
double worst_error(SessionNetwork &network, PeerId at) {
	double worst = 0.0;
	for (const auto &[body, owner] : network.peers.at(at).owners) {
		worst = owner == at ? worst : std::max(worst, network.error(body, at));
	}
	return worst;
}

} // namespace

TEST_CASE("relay: bodies of all owners arrive at all peers within the tolerance, and clients send to the server only") {
	for (const bool is_star : { true, false }) {
		SessionNetwork network = network_of_owners(4, { 0.03, 0.01 }, is_star);
		network.run(2.5);
		double worst = 0.0;
		network.run(4.0, [&] {
			for (PeerId at = 1; at <= 5; ++at) {
				worst = std::max(worst, worst_error(network, at));
			}
		});
		CAPTURE(is_star);
		CHECK(worst <= 1.3);
		CHECK(std::all_of(network.sent.begin(), network.sent.end(), [](const SessionNetwork::SentPacket &packet) { return packet.from == SERVER || packet.to == SERVER; }));
		for (PeerId at = 1; at <= 5; ++at) {
			CHECK(network.total(at).rejected == 0);
			CHECK(network.total(at).unauthorized == 0);
			CHECK(network.peers[at].poses_rejected == 0);
		}
		CHECK(network.session(2).relayed_owners() == std::vector<PeerId>{ 3, 4, 5 });
		CHECK(network.session(SERVER).relayed_owners().empty());
		CHECK(network.session(2).can_receive(3));
		CHECK_FALSE(network.session(SERVER).can_receive(77));
		const SessionStatistics relayed = network.statistics(3, 2);
		CHECK(relayed.received_bytes > 20.0);
		CHECK(relayed.playback_delay > 0.1);
		CHECK(relayed.playback_delay < 0.25);
		CHECK(network.session(2).media_time(3) > 5.0);
		CHECK(network.statistics(SERVER, 2).received_bytes > 3.0 * relayed.received_bytes);
		CHECK(network.total(2).received_bytes == network.statistics(SERVER, 2).received_bytes);
	}
}

TEST_CASE("relay: motion arrives at most a tick later than directly, apart from the second link") {
	const auto delay_with = [](bool relay, double latency) {
		SessionNetwork network({ latency });
		for (PeerId id = 1; id <= 4; ++id) {
			network.join(id).set_relay(relay);
		}
		for (uint32_t body = 1; body <= 4; ++body) {
			network.paths[body] = smooth_path(body);
			network.set_owner(body, PeerId(body));
		}
		network.run(3.0);
		double delay = 0.0;
		network.run(3.0, [&] { delay = std::max(delay, network.now - network.peers[3].origin - network.session(2).media_time(3)); });
		return delay;
	};
	CHECK(delay_with(true, 0.02) <= delay_with(false, 0.04) + 1.0 / 60.0 + 0.001);
}

TEST_CASE("relay: over impaired links all peers end at the owners' poses") {
	for (const LinkSettings &link : { LinkSettings{ 0.03, 0.1, 0.3, 0.1 }, LinkSettings{ 0.05, 0.02, 0.5 }, LinkSettings{ 0.01, 0.2, 0.0, 1.0 } }) {
		SessionNetwork network = network_of_owners(3, link);
		for (auto &[body, path] : network.paths) {
			path = [moving = path](double time) { return moving(std::min(time, 108.0)); };
		}
		network.run(14.0);
		CAPTURE(link.loss);
		for (PeerId at = 1; at <= 4; ++at) {
			CHECK(worst_error(network, at) <= 1.02);
			CHECK(network.total(at).rejected == 0);
		}
	}
}

TEST_CASE("relay: clients may join late, owners may leave and return") {
	SessionNetwork network = network_of_owners(3);
	network.run(3.0);
	network.join(9).set_relay(true);
	for (const auto &[body, owner] : std::map<uint32_t, PeerId>(network.peers[SERVER].owners)) {
		network.set_owner(9, body, owner);
	}
	network.run(1.0);
	CHECK(worst_error(network, 9) <= 1.3);
	network.leave(3);
	network.run(0.2);
	for (const PeerId at : { 2, 4, 9 }) {
		CHECK(network.session(at).stream(3) == nullptr);
	}
	network.join(8).set_relay(true);
	for (const auto &[body, owner] : std::map<uint32_t, PeerId>(network.peers[SERVER].owners)) {
		network.set_owner(body, owner == 3 ? 8 : owner);
	}
	network.run(1.5);
	for (const PeerId at : { 1, 2, 4, 8, 9 }) {
		CHECK(worst_error(network, at) <= 1.3);
		CHECK(network.total(at).rejected == 0);
	}
}

TEST_CASE("relay: a body that changes its owner is shown in the stream of the new one") {
	SessionNetwork network = network_of_owners(3);
	network.run(3.0);
	for (const PeerId owner : { 3, 4, 1, 2 }) {
		network.set_owner(4, owner);
		network.run(1.5);
		for (PeerId at = 1; at <= 4; ++at) {
			CAPTURE(owner);
			CAPTURE(at);
			CHECK((at == owner || network.error(4, at) <= 1.3));
			CHECK(network.total(at).rejected == 0);
		}
	}
}

TEST_CASE("relay: the server stops relaying a stream with bodies of other owners, says so once, and resumes") {
	SessionNetwork network = network_of_owners(3);
	network.run(2.0);
	network.set_owner(2, 2, 2);
	network.set_owner(2, 6, 2); // body 6 belongs to peer 4, but peer 2 sends it, too
	network.run(0.5);
	CHECK(network.peers[SERVER].reports.empty());
	network.run(2.0);
	REQUIRE(network.peers[SERVER].reports.size() == 1);
	CHECK(network.peers[SERVER].reports[0].first == 2);
	CHECK(network.peers[SERVER].reports[0].second.error == PacketError::UNAUTHORIZED_BODIES);
	const double known = network.session(3).stream(2)->known_time();
	network.run(1.0);
	CHECK(network.session(3).stream(2)->known_time() == known);
	CHECK(network.error(6, 3) <= 1.3); // from its owner
	network.set_owner(2, 6, 4);
	network.run(2.0);
	CHECK(network.error(2, 3) <= 1.3);
	CHECK(network.peers[SERVER].reports.size() == 1);
}

TEST_CASE("relay: if the server and a client differ in relaying, each says so once, and all streams work") {
	for (const bool server_relays : { true, false }) {
		SessionNetwork network({ 0.03 });
		for (PeerId id = 1; id <= 4; ++id) {
			network.join(id).set_relay(id == SERVER ? server_relays : id == 2 ? !server_relays
																			  : server_relays);
		}
		for (uint32_t body = 1; body <= 4; ++body) {
			network.paths[body] = smooth_path(body);
			network.set_owner(body, PeerId(body));
		}
		network.run(4.0);
		CAPTURE(server_relays);
		for (PeerId at = 1; at <= 4; ++at) {
			CAPTURE(at);
			CHECK(worst_error(network, at) <= 1.3);
			const auto &reports = network.peers[at].reports;
			REQUIRE(reports.size() == (at <= 2 ? 1 : 0));
			if (at <= 2) {
				CHECK(reports[0].first == 3 - at);
				CHECK(reports[0].second.error == PacketError::RELAY_DIFFERS);
				CHECK(reports[0].second.count == 1);
			}
		}
	}
}

TEST_CASE("relay: relaying can be switched on and off while streams run") {
	SessionNetwork network = network_of_owners(3, { 0.03 }, false);
	for (const bool relay : { false, true, false }) {
		network.run(2.0);
		for (auto &entry : network.peers) {
			entry.second.session.set_relay(relay);
		}
		network.run(2.0);
		CAPTURE(relay);
		for (PeerId at = 1; at <= 4; ++at) {
			CHECK(worst_error(network, at) <= 1.3);
		}
	}
}

TEST_CASE("relay: while the server makes no ticks, it relays; after it was blocked, playback is smooth again") {
	for (const bool is_blocked : { false, true }) {
		SessionNetwork network = network_of_owners(3);
		network.run(3.0);
		SessionNetwork::Peer &server = network.peers.at(SERVER);
		(is_blocked ? server.blocked_until : server.held_until) = network.now + 2.0;
		double worst = 0.0;
		const auto measure = [&] { worst = std::max(worst, std::max(network.error(2, 3), network.error(4, 4))); };
		if (is_blocked) {
			network.run(2.5);
		} else {
			network.run(2.0, measure);
		}
		network.run(2.0, measure);
		CAPTURE(is_blocked);
		CHECK(worst <= 1.3);
		CHECK(network.statistics(3, 2).playback_delay < 0.25);
		CHECK(worst_error(network, 2) <= 1.3);
	}
}

TEST_CASE("relay: at any tick rate and latency, and with packets of any size, bodies of all owners are within the tolerance") {
	struct Row {
		double tick;
		double max_latency;
		size_t max_packet_size;
	};
	for (const Row &row : { Row{ 1.0 / 20.0, 0.2, 1100 }, Row{ 1.0 / 30.0, 0.1, 576 }, Row{ 1.0 / 60.0, 0.1, 1400 }, Row{ 1.0 / 60.0, 0.05, 256 }, Row{ 1.0 / 128.0, 0.1, 1100 } }) {
		SessionNetwork network({ 0.02, 0.002 });
		network.is_star = true;
		network.tick = row.tick;
		network.transport_limit = row.max_packet_size;
		StreamSettings settings;
		settings.max_latency = row.max_latency;
		settings.max_packet_size = row.max_packet_size;
		for (PeerId id = 1; id <= 6; ++id) {
			network.peers[id].session.set_relay(true);
			network.peers[id].session.set_settings(settings);
			network.join(id);
		}
		for (uint32_t body = 0; body < 60; ++body) {
			network.paths[body] = smooth_path(body);
			network.set_owner(body, PeerId(body % 6 + 1));
		}
		network.run(3.0);
		double worst = 0.0;
		network.run(3.0, [&] { worst = std::max(worst, worst_error(network, 2)); });
		CAPTURE(row.tick);
		CAPTURE(row.max_latency);
		CHECK(worst <= 1.5);
		CHECK(network.total(2).rejected == 0);
		CHECK(std::all_of(network.sent.begin(), network.sent.end(), [&](const SessionNetwork::SentPacket &packet) { return packet.bytes.size() + Session::ENGINE_HEADER <= row.max_packet_size; }));
	}
}

TEST_CASE("relay: a client that requests new streams all the time gets few snapshots") {
	SessionNetwork network = network_of_owners(3);
	for (uint32_t body = 100; body < 300; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, 3);
	}
	network.run(3.0);
	const double from = network.now;
	uint8_t link = 0;
	network.run(2.0, [&] { network.request(2, SERVER, link, OPEN_RELAY); });
	size_t bytes = 0;
	for (const SessionNetwork::SentPacket &packet : network.packets(SERVER, 2, PacketKind::MOTION, from)) {
		bytes += packet.bytes.size();
	}
	// A snapshot has about 10,000 bytes.
	CHECK(bytes <= 200000);
	network.run(3.0);
	CHECK(worst_error(network, 2) <= 1.3);
	CHECK(worst_error(network, 4) <= 1.3);
}

TEST_CASE("relay: if the transport refuses packets, they become smaller") {
	SessionNetwork network = network_of_owners(3);
	for (uint32_t body = 100; body < 220; ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, PeerId(body % 4) + 1);
	}
	network.run(2.0);
	network.transport_limit = 500;
	network.run(3.0);
	for (PeerId at = 1; at <= 4; ++at) {
		CHECK(worst_error(network, at) <= 1.3);
	}
}

namespace {

/// Packets of a kind per second from one peer to another, with `owners` clients that began to move at different times.
struct PacketRates {
	double motion = 0.0; // server to client
	double server_acks = 0.0;
	double acks = 0.0; // client to server
	double sent_motion = 0.0;
	double error = 0.0;
	double excess = 0.0; // fraction of frames with an error above 1.3
	double bytes = 0.0;
};

PacketRates packet_rates(int owners, double jitter, int frames, double max_latency, uint64_t seed = 0) {
	SessionNetwork network({ 0.03, jitter });
	network.link_seed = seed;
	StreamSettings settings;
	settings.max_latency = max_latency;
	network.frames_per_tick = frames;
	network.is_star = true;
	for (PeerId id = 1; id <= owners + 1; ++id) {
		network.peers[id].session.set_relay(true);
		network.peers[id].session.set_settings(settings);
		network.join(id);
		network.run(0.05 + 0.017 * double(id * 7 % 10));
	}
	for (uint32_t body = 2; body < 2 + uint32_t(owners); ++body) {
		network.paths[body] = smooth_path(body);
		network.set_owner(body, PeerId(body));
		network.run(0.017 * double(body * 5 % 9));
	}
	network.run(6.0);
	PacketRates rates;
	const double from = network.now;
	network.run(6.0, [&] { 
		const double error = worst_error(network, 2);
		rates.error = std::max(rates.error, error);
		rates.excess += error > 1.3 ? 1.0 / 360.0 : 0.0; });
	const auto rate = [&](PeerId sender, PeerId to, PacketKind kind) { return double(network.packets(sender, to, kind, from).size()) / 6.0; };
	rates.motion = rate(SERVER, 2, PacketKind::MOTION);
	rates.server_acks = rate(SERVER, 2, PacketKind::ACK);
	rates.acks = rate(2, SERVER, PacketKind::ACK);
	rates.sent_motion = rate(2, SERVER, PacketKind::MOTION);
	rates.bytes = network.statistics(SERVER, 2).received_bytes;
	return rates;
}

} // namespace

TEST_CASE("relay: the number of datagrams for each client does not depend on the number of owners") {
	struct Row {
		double max_latency;
		int frames;
		double packets;
	};
	constexpr uint64_t SEEDS = 5;
	for (const Row &row : { Row{ 0.2, 1, 6.7 }, Row{ 0.2, 2, 6.7 }, Row{ 0.1, 1, 20.0 }, Row{ 0.1, 4, 20.0 } }) {
		const int frames = row.frames;
		CAPTURE(row.max_latency);
		CAPTURE(frames);
		const PacketRates two = packet_rates(2, 0.0, frames, row.max_latency);
		CHECK(two.motion <= 1.03 * row.packets);
		for (const int owners : { 4, 8, 16 }) {
			CAPTURE(owners);
			const PacketRates more = packet_rates(owners, 0.0, frames, row.max_latency);
			CHECK(more.motion <= 1.05 * two.motion);
			CHECK(more.server_acks <= 1.05 * two.server_acks);
			CHECK(more.acks <= 1.05 * two.acks);
			CHECK(more.sent_motion <= 1.05 * two.sent_motion);
			CHECK(more.error <= 1.3);
			// Bytes grow with the number of owners only.
			CHECK(more.bytes <= 1.1 * two.bytes * double(owners - 1));
		}
		// Jitter disperses the arrivals at the server.
		for (const double jitter : { 0.005, 0.02 }) {
			CAPTURE(jitter);
			std::vector<double> motion;
			std::vector<double> acks;
			for (uint64_t seed = 0; seed < SEEDS; ++seed) {
				const PacketRates many = packet_rates(16, jitter, frames, row.max_latency, 1000 * seed);
				motion.push_back(many.motion);
				acks.push_back(many.acks);
				CHECK(many.excess <= 0.01);
			}
			// An owner that is not aligned for a while costs packets of its own.
			std::sort(motion.begin(), motion.end());
			std::sort(acks.begin(), acks.end());
			CHECK(motion[SEEDS / 2] <= 1.5 * row.packets);
			CHECK(acks[SEEDS / 2] <= 1.5 * row.packets);
		}
	}
}
