#pragma once

#include "hostile_stream.hpp"
#include "live_bytes.hpp"

#include "net/session/session.hpp"

#include <optional>
#include <vector>

// net::Session with a hostile peer, next to an honest one.

namespace fuzz {

constexpr net::PeerId TESTED = 1;
constexpr net::PeerId HONEST = 2;
constexpr net::PeerId HOSTILE = 3;
/// Placeholder in recorded packets for the link that the tested session chooses.
constexpr uint8_t CHOSEN_LINK = 0xa5;

inline bool has_chosen_link(const Bytes &packet) {
	const auto envelope = net::read_envelope(packet.data(), packet.size());
	return envelope && (envelope->kind == net::PacketKind::MOTION || envelope->kind == net::PacketKind::CLOSE);
}

/// A session with the bodies that it owns, number `id`, `id` + 10 and so on.
struct SessionEnd {
	SessionEnd(net::PeerId id, const std::vector<net::PeerId> &others, uint32_t owned, bool relay = false) :
			id(id), owned(owned) {
		session.set_relay(relay);
		session.connect(id);
		(void)session.set_peers(others, 0.0);
	}

	void step(double now) {
		session.begin_tick(now, TICK);
		for (uint32_t i = 0; session.is_sending() && i < owned; ++i) {
			require(session.observe(uint32_t(id) + 10 * i, path(now)), "a valid pose was rejected");
		}
		session.end_tick();
		session.advance(now);
	}

	/// Along a line, which costs the encoder the least time.
	[[nodiscard]] cga::Pose<double> path(double time) const {
		cga::Pose<double> pose;
		pose.translation = cga::Vector3<double>(double(id), 0.5 * time, 0.0);
		return pose;
	}

	net::Session session{ net::StreamSettings() };
	net::PeerId id;
	uint32_t owned;
};

inline void set_owners(net::Session &session, uint32_t hostile_bodies) {
	session.set_owner(TESTED, TESTED);
	session.set_owner(HONEST, HONEST);
	for (uint32_t i = 0; i < hostile_bodies; ++i) {
		session.set_owner(HOSTILE + 10 * i, HOSTILE);
	}
}

/// The packets of a peer to the tested session, from its first OPEN to CLOSE.
inline std::vector<Bytes> record_session(bool relay) {
	constexpr uint32_t BODIES = 4;
	SessionEnd tested(TESTED, { HOSTILE }, 1, relay);
	SessionEnd peer(HOSTILE, { TESTED }, BODIES, relay);
	set_owners(tested.session, BODIES);
	set_owners(peer.session, BODIES);
	std::vector<Bytes> packets;
	const auto exchange = [&](double now) {
		tested.session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) { peer.session.accept(TESTED, bytes, packet.size, now); });
		peer.session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
			packets.emplace_back(bytes, bytes + packet.size);
			if (has_chosen_link(packets.back())) {
				packets.back()[3] = CHOSEN_LINK;
			}
			tested.session.accept(HOSTILE, bytes, packet.size, now);
		});
	};
	for (int tick = 1; tick < 180; ++tick) {
		const double now = tick * TICK;
		tested.step(now);
		peer.step(now);
		exchange(now);
	}
	peer.session.close(180 * TICK);
	exchange(180 * TICK);
	return packets;
}

/// The tested session and the honest one, which are directly connected, and the hostile peer.
class SessionTarget {
public:
	/// The hostile peer owns some bodies or none. With `relay`, the tested session relays to both others.
	SessionTarget(bool has_authority, bool relay) :
			_tested(TESTED, { HONEST, HOSTILE }, 1, relay), _honest(HONEST, { TESTED }, 1, relay) {
		set_owners(_tested.session, has_authority ? 4 : 0);
		set_owners(_honest.session, 0);
		for (int tick = 0; tick < 40; ++tick) {
			step();
		}
		_is_running = true;
	}

	void attack(Bytes &packet) {
		if (has_chosen_link(packet) && packet[3] == CHOSEN_LINK) {
			packet[3] = _chosen_link;
		}
		_tested.session.accept(HOSTILE, packet.data(), packet.size(), _now);
		step();
	}

	void step() {
		_now += TICK;
		_honest.step(_now);
		_honest.session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) { _tested.session.accept(HONEST, bytes, packet.size, _now); });
		_tested.step(_now);
		size_t sent = 0;
		_tested.session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
			sent += packet.size;
			const auto envelope = net::read_envelope(bytes, packet.size);
			require(envelope.has_value(), "a packet has no envelope");
			if (packet.peer == HONEST) {
				_honest.session.accept(TESTED, bytes, packet.size, _now);
			} else if (envelope->kind == net::PacketKind::OPEN) {
				_chosen_link = envelope->link;
			}
		});
		require(sent < 400000, "the session sends 400,000 bytes or more in a tick");
		_tested.session.report_rejections([](net::PeerId peer, const net::Rejections::Report &) { require(peer == HOSTILE, "a packet of the honest peer was rejected"); });
		if (_is_running) {
			check_stream(_tested, _honest);
			check_stream(_honest, _tested);
			check_hostile_stream();
		}
	}

	/// The hostile peer leaves.
	void end() {
		const bool has_left = _tested.session.set_peers({ HONEST }, _now) == std::vector<net::PeerId>{ HOSTILE };
		require(has_left && _tested.session.stream(HOSTILE) == nullptr, "the hostile peer has not left");
		step();
	}

private:
	/// The receiver shows the sender's body where it was.
	void check_stream(SessionEnd &receiver, SessionEnd &sender) {
		const net::Receiver *stream = receiver.session.stream(sender.id);
		require(stream != nullptr, "the honest stream has ended");
		const auto shown = stream->pose(uint32_t(sender.id));
		require(shown.has_value(), "a body of the honest stream is not shown");
		const double time = _now - sender.session.media_time(sender.id) + stream->media_time();
		require(glm::length(shown->translation - sender.path(time).translation) < 0.02, "a body of the honest stream is elsewhere");
		require(receiver.session.statistics(sender.id, _now).rejected == 0, "packets of the honest stream are rejected");
	}

	void check_hostile_stream() {
		const net::Receiver *stream = _tested.session.stream(HOSTILE);
		require(std::isfinite(_tested.session.media_time(HOSTILE)), "the media time is not finite");
		for (uint32_t i = 0; stream != nullptr && i < 4; ++i) {
			require_finite(stream->pose(HOSTILE + 10 * i).value_or(cga::Pose<double>()));
		}
	}

	SessionEnd _tested;
	SessionEnd _honest;
	double _now = 0.0;
	uint8_t _chosen_link = 0;
	bool _is_running = false; // the honest streams
};

/// The packets of a hostile peer: recorded ones, in order or not, edited ones, and others that it makes.
class HostilePackets {
public:
	HostilePackets(const std::vector<Bytes> &recorded, Input &input) :
			_recorded(recorded), _input(input), _stream(input) {}

	Bytes next() {
		const uint8_t choice = _input.byte();
		if (choice < 96) {
			return _recorded[_next++ % _recorded.size()];
		}
		Bytes packet;
		if (choice < 160) {
			_next = choice % 4 == 0 ? _input.below(_recorded.size()) : _next;
			packet = _recorded[_next++ % _recorded.size()];
			for (size_t edits = choice % 3; edits > 0; --edits) {
				edit(packet, _input);
			}
			return packet;
		}
		packet.resize(net::ENVELOPE_BYTES);
		const uint8_t link = choice % 4 != 0 ? CHOSEN_LINK : _input.byte();
		net::write_envelope({ choice < 224 ? net::PacketKind::MOTION : net::PacketKind(_input.byte() % 4), link }, packet.data());
		if (choice >= 240) {
			net::put_section_header(packet, { uint32_t(_input.bits(2)), net::PeerId(_input.bits(4)), 0, _input.below(2000) }, _input.flag());
		}
		const Bytes content = _input.flag() ? _stream.packet() : _input.take(_input.byte());
		packet.insert(packet.end(), content.begin(), content.end());
		return packet;
	}

private:
	const std::vector<Bytes> &_recorded;
	size_t _next = 0;
	Input &_input;
	HostileStream _stream;
};

} // namespace fuzz
