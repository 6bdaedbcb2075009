#include "net/session/session.hpp"

#include <algorithm>
#include <cstring>

// The packets that a session sends and accepts.

namespace net {

namespace {

/// After this many seconds without a packet, the owner may have lost the subscription: the receiver sends OPEN again.
constexpr double SILENCE = 1.0;

} // namespace

void Session::send(PeerId id, Peer &peer, PacketKind kind, uint8_t link, const uint8_t *bytes, size_t size) {
	uint8_t *packet = _outbox.add(id, kind == PacketKind::OPEN || kind == PacketKind::CLOSE, ENVELOPE_BYTES + size);
	write_envelope({ kind, link, ENVELOPE_VERSION }, packet);
	if (size > 0) {
		std::memcpy(packet + ENVELOPE_BYTES, bytes, size);
	}
	peer.sent.add(ENVELOPE_BYTES + size, _now);
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
	bytes += ENVELOPE_BYTES;
	size -= ENVELOPE_BYTES;
	PacketResult result;
	if (envelope->version != ENVELOPE_VERSION) {
		result = PacketError::OTHER_SESSION_VERSION;
	} else if (envelope->kind == PacketKind::OPEN) {
		result = accept_open(id, peer, envelope->link, bytes, size, now);
	} else if (envelope->kind == PacketKind::CLOSE) {
		result = accept_close(id, peer, envelope->link, bytes, size);
	} else if (envelope->kind == PacketKind::MOTION) {
		result = accept_motion(id, peer, envelope->link, bytes, size, now);
	} else {
		result = accept_ack(id, peer, envelope->link, bytes, size, now);
	}
	if (!result) {
		peer.rejections.add(result.error());
		_rejected++;
	}
}

PacketResult Session::accept_open(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	const bool is_for_relay = size > 0 && bytes[0] == OPEN_RELAY;
	const PacketResult result = note_relay(id, peer, is_for_relay);
	if (is_for_relay && id != RelayedStreams::SERVER && !is_relaying()) {
		return result; // the peer requests a plain stream when it learns that we do not relay
	}
	if (peer.requested != link) {
		peer.requested = link;
		if (stream(id) == nullptr && peer.refused_size == 0) {
			// The peer's session may be newer than our last request.
			peer.open.restart(now);
		}
	}
	start_requested();
	return result;
}

PacketResult Session::accept_motion(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	if (peer.link != link) {
		return peer.ended_recently(now) ? PacketResult() : PacketError::STREAM_NOT_REQUESTED;
	}
	if (!peer.stream) {
		peer.stream.emplace(MAX_BODIES);
		peer.stream->set_margin_limits(_min_margin, _max_margin);
		if (is_relaying()) {
			_relayer.add_stream(id, *peer.stream, _running_time);
		}
	}
	const PacketResult result = is_relayed(id) ? _relayed.accept(_self, bytes, size, now, *peer.stream) : peer.stream->accept(bytes, size, now);
	_relayer.note_arrival(id, _running_time);
	if (peer.stream->is_refused()) {
		refuse_stream(id, peer);
	} else if (result) {
		peer.open.restart(now + SILENCE);
		if (peer.stream->is_ready()) {
			peer.refused_size = 0;
			peer.refusal_pause = Repetition::FIRST;
		}
	}
	return result;
}

/// Closes a stream with too many bodies and requests it again later.
void Session::refuse_stream(PeerId id, Peer &peer) {
	const size_t size = peer.stream->stream_size();
	send_close(id, peer, peer.link, CloseRole::RECEIVER);
	end_stream(id, peer);
	request_stream(peer);
	peer.refused_size = size;
	peer.open.restart(_now + peer.refusal_pause);
	peer.refusal_pause = std::min(2.0 * peer.refusal_pause, Peer::MAX_REFUSAL_PAUSE);
}

PacketResult Session::accept_ack(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	const auto accept_own = [&](const uint8_t *own, size_t own_size) {
		return peer.is_subscribed(link) ? _sender->accept(uint32_t(id), own, own_size, _running_time) : PacketResult();
	};
	if (peer.relay_link == link) {
		return _relayer.accept(id, bytes, size, _running_time, accept_own);
	}
	if (!peer.is_subscribed(link)) {
		return peer.ended_recently(now) ? PacketResult() : PacketError::NOT_SUBSCRIBED;
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
	} else if (role == CloseRole::SENDER && peer.link == link) {
		// The sender may return.
		end_stream(id, peer);
		request_stream(peer);
	} else if (role == CloseRole::RECEIVER && peer.requested == link) {
		peer.requested.reset();
		unsubscribe(id, peer);
	}
	return {};
}

} // namespace net
