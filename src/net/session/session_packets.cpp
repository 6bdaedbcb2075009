#include "net/session/session.hpp"

#include <algorithm>
#include <cstring>
#include <random>

// The packets that a session sends and accepts.

namespace net {

namespace {

/// After this many seconds without a packet, the owner may have lost the subscription: the receiver sends OPEN again.
constexpr double SILENCE = 1.0;
/// An OPEN that was sent so recently, in seconds, need not be sent again when the peer sends its own.
constexpr double RECENT_OPEN = 0.05;
/// Minimum pause before a stream is requested again that took too much work, in seconds.
constexpr double MIN_OVERLOAD_PAUSE = 1.0;
/// A peer that owns no bodies is sent OPEN packets forever. If they were all reliable, those of an outage would accumulate, and
/// reliable packets of the game would wait for them. (ENet also drops unreliable packets when the round trips of reliable ones vary.)
constexpr int MAX_RELIABLE_OPENS = 8;

uint16_t random_token() {
	thread_local std::mt19937 generator{ std::random_device{}() };
	return uint16_t(generator());
}

} // namespace

void Session::send(PeerId id, Peer &peer, PacketKind kind, uint8_t link, const uint8_t *bytes, size_t size) {
	// A challenge is repeated with the OPEN that causes it.
	const bool is_request = kind == PacketKind::OPEN && size > 0 && (bytes[0] & OPEN_CHALLENGE) == 0;
	const bool is_reliable = kind == PacketKind::CLOSE || (is_request && !peer.stream && !peer.is_request_known && peer.opens_sent <= MAX_RELIABLE_OPENS);
	uint8_t *packet = _outbox.add(id, is_reliable, ENVELOPE_BYTES + size);
	write_envelope({ kind, link, ENVELOPE_VERSION }, packet);
	if (size > 0) {
		std::memcpy(packet + ENVELOPE_BYTES, bytes, size);
	}
	peer.sent.add(ENVELOPE_BYTES + size, _now);
}

void Session::send_open(PeerId id, Peer &peer, uint8_t link, uint8_t flags, uint16_t token) {
	const uint8_t relay = is_relaying() || is_relayed(id) ? OPEN_RELAY : 0;
	const uint8_t content[OPEN_BYTES + TOKEN_BYTES] = { uint8_t(flags | relay), STREAM_VERSION, uint8_t(token), uint8_t(token >> 8) };
	send(id, peer, PacketKind::OPEN, link, content, flags != 0 ? sizeof(content) : OPEN_BYTES);
}

void Session::send_close(PeerId id, Peer &peer, uint8_t link, CloseRole role) {
	const uint8_t byte = uint8_t(role);
	send(id, peer, PacketKind::CLOSE, link, &byte, 1);
}

void Session::accept(PeerId id, const uint8_t *bytes, size_t size, double now) {
	const auto envelope = read_envelope(bytes, size);
	const auto found = _peers.find(id);
	if (!envelope || found == _peers.end()) {
		return;
	}
	now = set_now(now);
	Peer &peer = found->second;
	peer.received.add(size, now);
	const PacketBudget::Verdict verdict = peer.packets.take(size, _owners.expected(id), now);
	if (verdict == PacketBudget::Verdict::IGNORED) {
		peer.rejections.add_ignored();
		++_rejected;
		return;
	}
	bytes += ENVELOPE_BYTES;
	size -= ENVELOPE_BYTES;
	PacketResult result;
	if (verdict == PacketBudget::Verdict::FLOOD_BEGINS) {
		// Both streams may begin again after the flood.
		result = PacketError::TOO_MANY_PACKETS;
		close_subscription(id, peer);
		end_if_refused(id, peer, result);
	} else if (envelope->version != ENVELOPE_VERSION) {
		result = PacketError::OTHER_SESSION_VERSION;
	} else if (envelope->kind == PacketKind::OPEN) {
		result = accept_open(id, peer, envelope->link, bytes, size);
	} else if (envelope->kind == PacketKind::CLOSE) {
		result = accept_close(id, peer, envelope->link, bytes, size);
	} else if (envelope->kind == PacketKind::MOTION) {
		result = accept_motion(id, peer, envelope->link, bytes, size, now);
	} else {
		result = accept_ack(id, peer, envelope->link, bytes, size, now);
	}
	if (!result) {
		const bool is_session = result.error() == PacketError::OTHER_SESSION_VERSION;
		peer.rejections.add(result.error(), is_session ? envelope->version : peer.stream_version);
		++_rejected;
	}
}

PacketResult Session::accept_open(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size) {
	const uint8_t flags = size > 0 ? bytes[0] : 0;
	const bool has_token = (flags & (OPEN_CHALLENGE | OPEN_TOKEN)) != 0;
	if ((flags & ~OPEN_FLAGS) != 0 || (has_token && size < OPEN_BYTES + TOKEN_BYTES)) {
		return PacketError::MALFORMED_OPEN;
	}
	if (size > 1 && bytes[1] != STREAM_VERSION) {
		peer.stream_version = bytes[1];
		return PacketError::OTHER_STREAM_VERSION;
	}
	const uint16_t token = has_token ? uint16_t(bytes[OPEN_BYTES] | bytes[OPEN_BYTES + 1] << 8) : 0;
	if ((flags & OPEN_CHALLENGE) != 0) {
		if (peer.is_open_sent() && peer.link == link) {
			send_open(id, peer, link, OPEN_TOKEN, token);
			peer.is_request_known = true;
		}
		return {};
	}
	const bool is_for_relay = (flags & OPEN_RELAY) != 0;
	const PacketResult result = note_relay(id, peer, is_for_relay);
	if (is_for_relay && id != RelayedStreams::SERVER && !is_relaying()) {
		return result; // the peer requests a plain stream when it learns that we do not relay
	}
	if (peer.requested != link) {
		// A stream is far larger than the request. So the peer has to prove that it receives what is sent to it.
		if ((flags & OPEN_TOKEN) == 0 || peer.challenged != link || peer.token != token) {
			if (!peer.token || peer.challenged != link) {
				peer.token = random_token();
				peer.challenged = link;
				if (stream(id) == nullptr && !peer.is_refused && _now - peer.opened_at > RECENT_OPEN) {
					// The peer's session may be newer than our last request.
					peer.open.hasten(_now);
				}
			}
			send_open(id, peer, link, OPEN_CHALLENGE, *peer.token);
			return result;
		}
		peer.token.reset();
		peer.requested = link;
	}
	start_requested();
	return result;
}

PacketResult Session::accept_motion(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	if (peer.link != link || !peer.is_open_sent()) {
		return peer.ended_recently(link, now) ? PacketResult() : PacketError::STREAM_NOT_REQUESTED;
	}
	if (!peer.stream) {
		peer.stream.emplace(MAX_BODIES, peer.work);
		peer.stream->set_margin_limits(_min_margin, _max_margin);
		if (is_relaying()) {
			_relayer.add_stream(id, *peer.stream, _running_time);
		}
	}
	peer.limit_work(_owners.expected(id), now);
	const PacketResult result = is_relayed(id) ? _relayed.accept(_self, bytes, size, now, *peer.stream) : peer.stream->accept(bytes, size, now);
	_relayer.note_arrival(id, _running_time);
	if (result) {
		peer.open.restart(now + SILENCE);
	}
	end_if_refused(id, peer, result);
	return result;
}

/// Takes the result of a packet of a peer's stream, or of decoding what has waited. Closes a stream with too many bodies or of another
/// version, or one that takes too much work or comes in a flood, and requests it again later.
void Session::end_if_refused(PeerId id, Peer &peer, const PacketResult &result) {
	if (!peer.stream) {
		return;
	}
	const bool is_flood = !result && result.error() == PacketError::TOO_MANY_PACKETS;
	const bool is_other_version = !result && result.error() == PacketError::OTHER_STREAM_VERSION;
	if (!is_flood && !is_other_version && !peer.stream->is_refused()) {
		if (result && peer.stream->is_ready()) {
			peer.is_refused = false;
			peer.refused_size = 0;
			peer.refusal_pause = _now - peer.refused_at > Peer::REFUSAL_MEMORY ? Repetition::FIRST : peer.refusal_pause;
		}
		return;
	}
	peer.stream_version = is_other_version ? peer.stream->other_version() : peer.stream_version;
	const size_t size = peer.stream->stream_size();
	const double min_pause = is_flood || peer.stream->budget().is_refused() ? MIN_OVERLOAD_PAUSE : 0.0;
	send_close(id, peer, peer.link, CloseRole::RECEIVER);
	end_stream(id, peer);
	peer.request_stream(_now);
	peer.is_refused = true;
	peer.refused_size = size;
	peer.refused_at = _now;
	peer.refusal_pause = std::max(peer.refusal_pause, min_pause);
	peer.open.restart(_now + peer.refusal_pause);
	peer.refusal_pause = std::min(2.0 * peer.refusal_pause, Peer::MAX_REFUSAL_PAUSE);
}

PacketResult Session::accept_ack(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	const auto accept_own = [&](const uint8_t *own, size_t own_size) {
		return peer.is_subscribed(link) ? _sender->accept(uint32_t(id), own, own_size, _running_time, _relay && id == RelayedStreams::SERVER) : PacketResult();
	};
	if (peer.relay_link == link) {
		return _relayer.accept(id, bytes, size, _running_time, accept_own);
	}
	if (!peer.is_subscribed(link)) {
		return peer.ended_recently(link, now) ? PacketResult() : PacketError::NOT_SUBSCRIBED;
	}
	return accept_own(bytes, size);
}

PacketResult Session::accept_close(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size) {
	const bool is_channel = size == 3 && bytes[0] == uint8_t(CloseRole::SENDER);
	if ((size != 1 && !is_channel) || bytes[0] > uint8_t(CloseRole::SENDER)) {
		return PacketError::MALFORMED_CLOSE;
	}
	const CloseRole role = CloseRole(bytes[0]);
	if (is_channel) {
		if (peer.link == link && is_relayed(id)) {
			_relayed.end(uint32_t(bytes[1] | bytes[2] << 8), _now);
		}
	} else if (role == CloseRole::SENDER && peer.link == link && peer.is_open_sent()) {
		// The sender may return.
		end_stream(id, peer);
		peer.request_stream(_now);
		peer.open.hasten(_now);
	} else if (role == CloseRole::RECEIVER && peer.requested == link) {
		peer.requested.reset();
		unsubscribe(id, peer);
	}
	return {};
}

} // namespace net
