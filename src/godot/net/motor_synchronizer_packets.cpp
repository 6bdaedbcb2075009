#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/classes/multiplayer_peer.hpp>

#include <algorithm>
#include <cstring>

// Packets from and to other peers. Nothing that arrives is trusted.

namespace ga_godot {

using godot::MultiplayerPeer;
using godot::PackedByteArray;
using godot::String;
using godot::vformat;

/// How long packets of a stream that has ended may still come in, in seconds; they are no offence.
static constexpr double AFTERMATH = 2.0;
/// After this long without anything the authority may have forgotten us.
static constexpr double SILENCE = 1.0;
/// Seconds between two packet_rejected signals about one peer.
static constexpr double REPORT_INTERVAL = 0.5;

void MotorSynchronizer::send(int32_t p_id, Peer &r_peer, net::PacketKind p_kind, uint8_t p_link, const uint8_t *p_bytes, size_t p_size, MultiplayerPeer::TransferMode p_mode) {
	PackedByteArray packet;
	packet.resize(int64_t(net::ENVELOPE_BYTES + p_size));
	uint8_t *bytes = packet.ptrw();
	net::write_envelope({ p_kind, _key, p_link }, bytes);
	if (p_size > 0) {
		std::memcpy(bytes + net::ENVELOPE_BYTES, p_bytes, p_size);
	}
	_api->send_bytes(packet, p_id, p_mode, int32_t(_channel));
	r_peer.sent.add(net::ENVELOPE_BYTES + p_size, _now);
}

void MotorSynchronizer::send_bye(int32_t p_id, Peer &r_peer, uint8_t p_link, bool p_from_sender) {
	const uint8_t role = p_from_sender ? 1 : 0;
	send(p_id, r_peer, net::PacketKind::CLOSE, p_link, &role, 1, MultiplayerPeer::TRANSFER_MODE_RELIABLE);
}

void MotorSynchronizer::_on_peer_packet(int64_t p_peer, const PackedByteArray &p_packet) {
	net::Envelope envelope;
	const size_t size = size_t(p_packet.size());
	const uint8_t *bytes = p_packet.ptr();
	if (!net::read_envelope(bytes, size, envelope) || envelope.key != _key || _self == 0) {
		return; // for somebody else
	}
	const int32_t id = int32_t(p_peer);
	if (!is_connected_peer(id)) {
		update_peers();
		if (!is_connected_peer(id)) {
			return;
		}
	}
	const double now = clock();
	const auto found = _peers.find(id);
	Peer *peer = found != _peers.end() ? &found->second : nullptr;
	if (peer != nullptr) {
		peer->received.add(size, now);
	}
	if (envelope.version != net::ENVELOPE_VERSION) {
		reject(id, "it is of another version of GA-Godot; use the same on all peers");
		return;
	}
	bytes += net::ENVELOPE_BYTES;
	const size_t length = size - net::ENVELOPE_BYTES;
	const bool is_aftermath = peer != nullptr && now - peer->ended_at < AFTERMATH;
	switch (envelope.kind) {
		case net::PacketKind::OPEN:
			subscribe(id, envelope.link, now);
			break;
		case net::PacketKind::CLOSE:
			if (length == 1 && bytes[0] <= 1) {
				take_bye(id, peer, envelope.link, bytes[0] == 1);
			} else {
				reject(id, "it is malformed");
			}
			break;
		case net::PacketKind::MOTION:
			if (peer != nullptr && peer->stream && peer->link == envelope.link) {
				if (const char *fault = peer->stream->accept(bytes, length, now)) {
					reject(id, fault);
				} else {
					peer->hello_due = now + SILENCE;
				}
			} else if (!is_aftermath) {
				reject(id, peer != nullptr && peer->stream ? "it belongs to a stream that was not asked for" : "its sender is the authority of no target here");
			}
			break;
		case net::PacketKind::ACK:
			if (peer != nullptr && peer->subscribed && peer->subscription == envelope.link) {
				// Between two ticks the time goes on, so that round trips are not measured in whole ticks.
				const double since_tick = std::min(std::max(now - _now, 0.0), _settings.tick);
				if (const char *fault = _sender->accept(uint32_t(id), bytes, length, media_time() + since_tick)) {
					reject(id, fault);
				}
			} else if (!is_aftermath) {
				reject(id, "it answers a stream that its sender does not get");
			}
			break;
	}
}

void MotorSynchronizer::take_bye(int32_t p_id, Peer *p_peer, uint8_t p_link, bool p_from_sender) {
	if (p_peer == nullptr) {
		return;
	}
	if (p_from_sender && p_peer->stream && p_peer->link == p_link) {
		// Its node may come back: the next stream is asked for until it does.
		forget_stream(*p_peer);
		_streams_stale = true;
	} else if (!p_from_sender && p_peer->subscribed && p_peer->subscription == p_link) {
		unsubscribe(p_id, *p_peer);
	}
}

/// Costs little: a hostile peer may cause it at any rate.
void MotorSynchronizer::reject(int32_t p_id, const char *p_reason) {
	Peer &peer = _peers[p_id];
	peer.reason = p_reason;
	peer.rejected++;
	peer.unreported++;
	_rejected++;
}

void MotorSynchronizer::report_rejections() {
	std::vector<std::pair<int32_t, String>> reports;
	for (auto &[id, peer] : _peers) {
		if (peer.unreported > 0 && _now - peer.reported_at >= REPORT_INTERVAL) {
			reports.emplace_back(id, vformat("Packet refused: %s (%d since the last report).", peer.reason, int64_t(peer.unreported)));
			peer.unreported = 0;
			peer.reported_at = _now;
		}
	}
	for (const auto &[id, text] : reports) {
		emit_signal("packet_rejected", id, text);
	}
}

} // namespace ga_godot
