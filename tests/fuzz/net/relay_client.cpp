#include "session_target.hpp"

#include <map>

// The client of a relaying server, with the packets of a hostile server.

namespace {

using namespace fuzz;

constexpr net::PeerId SERVER = 1;
constexpr net::PeerId CLIENT = 2;
constexpr net::PeerId OWNERS = 4; // peers 1 to 4 own a body each

void set_four_owners(net::Session &session) {
	for (net::PeerId owner = SERVER; owner <= OWNERS; ++owner) {
		session.set_owner(uint32_t(owner), owner);
	}
}

/// The packets of a relaying server to the client, from its first OPEN to CLOSE.
std::vector<Bytes> record_relay() {
	std::map<net::PeerId, SessionEnd> peers;
	for (net::PeerId id = SERVER; id <= OWNERS; ++id) {
		const std::vector<net::PeerId> others = id == SERVER ? std::vector<net::PeerId>{ 2, 3, 4 } : std::vector<net::PeerId>{ SERVER };
		set_four_owners(peers.try_emplace(id, id, others, 1, true).first->second.session);
	}
	std::vector<Bytes> packets;
	double now = 0.0;
	const auto exchange = [&] {
		for (auto &[id, peer] : peers) {
			peer.session.outbox().drain([&, from = id](const net::Outbox::Packet &packet, const uint8_t *bytes) {
				if (from == SERVER && packet.peer == CLIENT) {
					packets.emplace_back(bytes, bytes + packet.size);
					if (has_chosen_link(packets.back())) {
						packets.back()[3] = CHOSEN_LINK;
					}
				}
				peers.at(packet.peer).session.accept(from, bytes, packet.size, now);
			});
		}
	};
	for (int tick = 1; tick < 150; ++tick) {
		now = tick * TICK;
		for (auto &[id, peer] : peers) {
			peer.step(now);
		}
		if (tick == 120) {
			peers.at(3).session.close(now); // its relayed stream ends
		}
		exchange();
	}
	peers.at(SERVER).session.close(now);
	exchange();
	return packets;
}

} // namespace

void fuzz::run(Input input) {
	static const std::vector<Bytes> RECORDED = record_relay();
	SessionEnd client(CLIENT, { SERVER }, 1, true);
	set_four_owners(client.session);
	const size_t before = live_bytes();
	std::optional<HostilePackets> packets(std::in_place, RECORDED, input);
	uint8_t link = 0;
	double now = 0.0;
	const auto step = [&] {
		now += TICK;
		client.step(now);
		size_t sent = 0;
		client.session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
			sent += packet.size;
			const auto envelope = net::read_envelope(bytes, packet.size);
			require(envelope.has_value(), "a packet has no envelope");
			if (envelope->kind == net::PacketKind::OPEN) {
				link = envelope->link;
			}
		});
		require(sent < 400000, "the client sends 400,000 bytes or more in a tick");
		for (net::PeerId owner = SERVER; owner <= OWNERS; ++owner) {
			require(std::isfinite(client.session.media_time(owner)), "the media time is not finite");
			require(std::isfinite(client.session.statistics(owner, now).playback_delay), "the playback delay is not finite");
			const net::Receiver *stream = client.session.stream(owner);
			require_finite(stream != nullptr ? stream->pose(uint32_t(owner)).value_or(cga::Pose<double>()) : cga::Pose<double>());
		}
		require(live_bytes() < before + 4000000, "the hostile server makes the client use 4 MB or more");
	};
	step();
	for (int count = 0; !input.is_empty() && count < 64; ++count) {
		Bytes packet = packets->next();
		if (has_chosen_link(packet) && packet[3] == CHOSEN_LINK) {
			packet[3] = link;
		}
		client.session.accept(SERVER, packet.data(), packet.size(), now);
		step();
	}
	packets.reset();
	require(client.session.set_peers({}, now) == std::vector<net::PeerId>{ SERVER }, "the server has not left");
	require(client.session.stream(3) == nullptr, "a relayed stream has not ended");
	step();
	require(live_bytes() < before + 100000, "the memory of a server that has left is not released");
}
