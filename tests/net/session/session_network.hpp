#pragma once

#include "../../harness/simulated_link.hpp"
#include "../motion_scenes.hpp"
#include "net/session/session.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace net_test {

using harness::LinkSettings;
using harness::SimulatedLink;
using net::PeerId;

/// A session packet with the given content.
inline std::vector<uint8_t> make_packet(net::PacketKind kind, uint8_t link, const std::vector<uint8_t> &content = {}) {
	std::vector<uint8_t> bytes(net::ENVELOPE_BYTES);
	net::write_envelope({ kind, link, net::ENVELOPE_VERSION }, bytes.data());
	bytes.insert(bytes.end(), content.begin(), content.end());
	return bytes;
}

/// Peers with a session each, connected by simulated links, in virtual time. Reliable packets are delayed, but not lost.
class SessionNetwork {
public:
	struct Link {
		SimulatedLink unreliable;
		SimulatedLink reliable;
	};

	struct Peer {
		net::Session session{ net::StreamSettings() };
		std::map<uint32_t, PeerId> owners; // as known to this peer
		std::vector<std::pair<PeerId, net::Rejections::Report>> reports;
		double origin = 0.0; // virtual time at which the media time of its stream is 0
		int poses_rejected = 0;
		double held_until = 0.0; // virtual time until which it makes no ticks
		double blocked_until = 0.0; // virtual time until which its process does nothing
		double tick_share = 1.0; // fraction of its ticks that it makes
		double due_ticks = 0.0;
		int missed_ticks = 0;
		int max_catch_up = 0;
		int64_t ticks = 0;
	};

	struct SentPacket {
		PeerId from;
		PeerId to;
		net::Envelope envelope;
		bool reliable;
		double time;
		std::vector<uint8_t> bytes;

		[[nodiscard]] bool is_challenge() const { return envelope.kind == net::PacketKind::OPEN && bytes.size() > net::ENVELOPE_BYTES && (bytes[net::ENVELOPE_BYTES] & net::OPEN_CHALLENGE) != 0; }
	};

	/// All links have the same settings; by default 30 ms of delay.
	explicit SessionNetwork(const LinkSettings &link = { 0.03 }) :
			_link(link) {}

	net::Session &join(PeerId id) {
		peers[id].session.connect(id);
		update_peers();
		return peers[id].session;
	}

	void leave(PeerId id) {
		peers.erase(id);
		update_peers();
	}

	/// Ends the session of a peer, which stays connected, as when its node is removed.
	void close_session(PeerId id) {
		Peer &peer = peers[id];
		peer.session.close(local(id));
		send(id, peer);
		peer.session.connect(0);
		peer.owners.clear();
	}

	/// Sets the owner of a body at one peer.
	void set_owner(PeerId at, uint32_t body, PeerId owner) {
		peers[at].owners[body] = owner;
		peers[at].session.set_owner(body, owner);
	}

	/// Sets the owner of a body at all peers.
	void set_owner(uint32_t body, PeerId owner) {
		for (auto &entry : peers) {
			set_owner(entry.first, body, owner);
		}
	}

	/// Advances all peers by a tick and its frames.
	void step() {
		for (int frame = 0; frame < frames_per_tick; ++frame) {
			now += tick / frames_per_tick;
			for (auto &[id, peer] : peers) {
				if (now < peer.blocked_until) {
					continue;
				}
				receive(id, peer);
				if (frame == 0) {
					step_ticks(id, peer);
				}
				peer.session.advance(local(id));
				send(id, peer);
				peer.session.report_rejections([&reports = peer.reports](PeerId from, const net::Rejections::Report &report) { reports.emplace_back(from, report); });
			}
		}
	}

	template <class EachStep>
	void run(double seconds, EachStep &&each) {
		for (const double end = now + seconds - 1e-9; now < end;) {
			step();
			each();
		}
	}
	void run(double seconds) {
		run(seconds, [] {});
	}

	/// Delivers a packet at once.
	void inject(PeerId from, PeerId to, const std::vector<uint8_t> &bytes) {
		peers.at(to).session.accept(from, bytes.data(), bytes.size(), local(to));
	}

	/// A hostile peer requests streams: every second call requests the next `link`, the calls between prove that it receives replies.
	void request(PeerId from, PeerId to, uint8_t &link, uint8_t flags) {
		for (const SentPacket &packet : packets(to, from, net::PacketKind::OPEN)) {
			if (packet.envelope.link == link && packet.is_challenge() && answered != link) {
				answered = link;
				inject(from, to, make_packet(net::PacketKind::OPEN, link, { uint8_t(flags | net::OPEN_TOKEN), net::STREAM_VERSION, packet.bytes[net::ENVELOPE_BYTES + 2], packet.bytes[net::ENVELOPE_BYTES + 3] }));
				return;
			}
		}
		inject(from, to, make_packet(net::PacketKind::OPEN, ++link, { flags, net::STREAM_VERSION }));
	}
	/// The link of the stream that a peer has requested last.
	[[nodiscard]] uint8_t requested_link(PeerId from, PeerId to) const {
		uint8_t link = 0;
		for (const SentPacket &packet : packets(from, to, net::PacketKind::OPEN)) {
			link = packet.is_challenge() ? link : packet.envelope.link;
		}
		return link;
	}

	[[nodiscard]] net::Session &session(PeerId id) { return peers.at(id).session; }
	[[nodiscard]] bool is_streaming(PeerId from, PeerId to) { return session(to).stream(from) != nullptr; }
	/// The error of a body at a peer, relative to the tolerance; 1e9 if the peer does not show it.
	[[nodiscard]] double error(uint32_t body, PeerId at) {
		const PeerId owner = peers.at(at).owners.at(body);
		const net::Receiver *stream = session(at).stream(owner);
		const std::optional<PoseD> shown = stream != nullptr ? stream->pose(body) : std::nullopt;
		if (!shown) {
			return 1e9;
		}
		const net::StreamGrid grid(float(stream->settings().position_tolerance), float(stream->settings().rotation_tolerance));
		return error_share(*shown, paths.at(body)(peers.at(owner).origin + stream->media_time()), grid);
	}
	[[nodiscard]] net::SessionStatistics statistics(PeerId of, PeerId at) { return session(at).statistics(of, local(at)); }
	[[nodiscard]] net::SessionStatistics total(PeerId at) { return session(at).total_statistics(local(at)); }
	/// The time on a peer's clock; clocks are not synchronized.
	[[nodiscard]] double local(PeerId id) const { return now + 1000.0 * double(id) + (clock_jumps.count(id) != 0 ? clock_jumps.at(id) : 0.0); }
	[[nodiscard]] Link &link(PeerId from, PeerId to) {
		const auto found = _links.find({ from, to });
		if (found != _links.end()) {
			return found->second;
		}
		LinkSettings reliable = _link;
		reliable.loss = reliable.duplication = 0.0;
		const uint64_t seed = link_seed + uint64_t(from) * 100 + uint64_t(to);
		return _links.emplace(std::pair(from, to), Link{ SimulatedLink(_link, seed), SimulatedLink(reliable, ~seed) }).first->second;
	}

	/// The packets of a kind that a peer has sent to another since `since`.
	[[nodiscard]] std::vector<SentPacket> packets(PeerId from, PeerId to, net::PacketKind kind, double since = -1e9) const {
		std::vector<SentPacket> result;
		for (const SentPacket &packet : sent) {
			if (packet.from == from && packet.to == to && packet.envelope.kind == kind && packet.time >= since) {
				result.push_back(packet);
			}
		}
		return result;
	}

	std::map<PeerId, Peer> peers;
	std::map<uint32_t, Path> paths; // of the bodies, by virtual time
	bool has_planar_bodies = false; // bodies with odd numbers are planar
	std::vector<SentPacket> sent;
	std::vector<size_t> refusals; // what packet_refused() returned
	double now = 100.0;
	std::map<PeerId, double> clock_jumps; // sum of the jumps of a peer's clock
	double tick = 1.0 / 60.0;
	int frames_per_tick = 1;
	uint64_t link_seed = 0;
	int answered = -1; // link of the last challenge that `request` has answered
	bool is_star = false; // clients are connected to peer 1 only
	std::function<void(PeerId from, PeerId to, std::vector<uint8_t> &bytes)> rewrite; // changes packets on their way
	size_t transport_limit = size_t(1) << 20; // larger packets are refused, in bytes with the engine's header

private:
	void update_peers() {
		for (auto &entry : peers) {
			std::vector<PeerId> others;
			for (const auto &other : peers) {
				if (other.first != entry.first && (!is_star || entry.first == 1 || other.first == 1)) {
					others.push_back(other.first);
				}
			}
			(void)entry.second.session.set_peers(others, local(entry.first));
		}
	}

	/// The ticks that are due: after a hold, up to `max_catch_up` at once.
	void step_ticks(PeerId id, Peer &peer) {
		peer.missed_ticks += now < peer.held_until ? 1 : 0;
		if (now < peer.held_until) {
			return;
		}
		peer.due_ticks += peer.tick_share + std::min(peer.missed_ticks, peer.max_catch_up);
		peer.missed_ticks = 0;
		for (; peer.due_ticks > 1.0 - 1e-9; peer.due_ticks -= 1.0) {
			step_tick(id, peer);
		}
	}

	void step_tick(PeerId id, Peer &peer) {
		++peer.ticks;
		peer.session.begin_tick(local(id), tick);
		for (const auto &[body, owner] : peer.owners) {
			const auto path = paths.find(body);
			if (owner == id && path != paths.end() && peer.session.is_sending()) {
				peer.poses_rejected += peer.session.observe(body, path->second(now), has_planar_bodies && body % 2 == 1) ? 0 : 1;
			}
		}
		peer.session.end_tick();
		peer.origin = now - peer.session.media_time(id);
	}

	void receive(PeerId id, Peer &peer) {
		for (auto &[ends, link] : _links) {
			if (ends.second != id) {
				continue;
			}
			for (SimulatedLink *direction : { &link.reliable, &link.unreliable }) {
				// Sums of ticks are rounded: a packet of this tick may be due slightly later.
				while (const std::optional<harness::Delivery> packet = direction->receive(now + 1e-9)) {
					peer.session.accept(ends.first, packet->bytes.data(), packet->bytes.size(), local(id));
				}
			}
		}
	}

	void send(PeerId id, Peer &peer) {
		peer.session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
			const std::optional<net::Envelope> envelope = net::read_envelope(bytes, packet.size);
			REQUIRE(envelope);
			if (packet.size + net::Session::ENGINE_HEADER > transport_limit) {
				refusals.push_back(peer.session.packet_refused(packet.peer, packet.size));
				return;
			}
			sent.push_back({ id, packet.peer, *envelope, packet.reliable, now, { bytes, bytes + packet.size } });
			std::vector<uint8_t> content = sent.back().bytes;
			if (rewrite) {
				rewrite(id, packet.peer, content);
			}
			Link &to = link(id, packet.peer);
			(packet.reliable ? to.reliable : to.unreliable).send(now, content.data(), content.size());
		});
	}

	LinkSettings _link;
	std::map<std::pair<PeerId, PeerId>, Link> _links;
};

/// A smooth motion that is different for each body.
inline Path smooth_path(uint32_t body) {
	return [body](double time) {
		const double phase = time * (1.0 + 0.1 * double(body % 5)) + double(body);
		return turned_at(Vector3D(std::sin(phase), double(body), std::cos(1.3 * phase)), Vector3D(0.6, 0.0, 0.8), 0.7 * phase);
	};
}

/// Peers 1 and 2. Peer 1 owns body 5, which moves smoothly.
inline SessionNetwork network_of_two(const LinkSettings &link = { 0.03 }) {
	SessionNetwork network(link);
	network.join(1);
	network.join(2);
	network.paths[5] = smooth_path(5);
	network.set_owner(5, 1);
	return network;
}

} // namespace net_test
