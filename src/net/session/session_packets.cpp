#include "net/session/session.hpp"

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
	set_now(now);
	Peer &peer = found->second;
	peer.received.add(size, now);
	bytes += ENVELOPE_BYTES;
	size -= ENVELOPE_BYTES;
	PacketResult result;
	if (envelope->version != ENVELOPE_VERSION) {
		result = PacketError::OTHER_SESSION_VERSION;
	} else if (envelope->kind == PacketKind::OPEN) {
		accept_open(id, peer, envelope->link, now);
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

PacketResult Session::accept_motion(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	if (peer.link != link) {
		return peer.ended_recently(now) ? PacketResult() : PacketError::STREAM_NOT_REQUESTED;
	}
	if (!peer.stream) {
		peer.stream.emplace(MAX_BODIES);
		peer.stream->set_margin_limits(_min_margin, _max_margin);
	}
	const PacketResult result = peer.stream->accept(bytes, size, now);
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

PacketResult Session::accept_ack(PeerId id, const Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	if (!peer.is_subscribed(link)) {
		return peer.ended_recently(now) ? PacketResult() : PacketError::NOT_SUBSCRIBED;
	}
	return _sender->accept(uint32_t(id), bytes, size, _running_time);
}

PacketResult Session::accept_close(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size) {
	if (size != 1 || bytes[0] > uint8_t(CloseRole::SENDER)) {
		return PacketError::MALFORMED_CLOSE;
	}
	const CloseRole role = CloseRole(bytes[0]);
	if (role == CloseRole::SENDER && peer.link == link) {
		// The sender may return.
		end_stream(peer);
		request_stream(peer);
	} else if (role == CloseRole::RECEIVER && peer.requested == link) {
		peer.requested.reset();
		unsubscribe(id, peer);
	}
	return {};
}

} // namespace net
