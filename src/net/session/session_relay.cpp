#include "net/session/session.hpp"

// The part of Session that relays streams.

namespace net {

namespace {

/// Maximum size of a packet's sections.
constexpr size_t MAX_SECTIONS = size_t(MAX_PACKET_BYTES);

} // namespace

void Session::set_relay(bool relay) {
	if (relay == _relay) {
		return;
	}
	close(_now);
	for (auto &[id, peer] : _peers) {
		unsubscribe(id, peer);
		end_stream(id, peer);
		peer.requested.reset();
		peer.relay.reset();
		request_stream(peer);
	}
	_relay = relay;
	update_relay();
}

/// True on a client that requests a relayed stream from the server. It assumes that the server relays until it says otherwise.
bool Session::is_relay_client() const {
	const auto server = _peers.find(RelayedStreams::SERVER);
	return _relay && server != _peers.end() && server->second.relay.value_or(true);
}

/// Requests the other kind of streams if that has changed.
void Session::update_relay() {
	if (is_relay_client() == _is_link_relayed) {
		return;
	}
	for (auto &[id, peer] : _peers) {
		if (wants_stream(id)) {
			close_stream(id, peer);
		}
	}
	_is_link_relayed = !_is_link_relayed;
}

/// Records whether a peer relays. Fails, once, if the peer and the server do not agree.
PacketResult Session::note_relay(PeerId id, Peer &peer, bool relay) {
	if (peer.relay == relay) {
		return {};
	}
	peer.relay = relay;
	update_relay();
	const bool is_between_clients = _self != RelayedStreams::SERVER && id != RelayedStreams::SERVER;
	return is_between_clients || relay == _relay ? PacketResult() : PacketError::RELAY_DIFFERS;
}

void Session::relay_to(PeerId id, Peer &peer, uint8_t link) {
	if (peer.relay_link != link) {
		peer.relay_link = link;
		_relayer.add_client(id, _now);
	}
}

void Session::stop_relaying_to(PeerId id, Peer &peer) {
	if (peer.relay_link) {
		peer.relay_link.reset();
		_relayer.remove_client(id);
		peer.ended_at = _now;
	}
}

/// Ends what depends on the stream of a peer: on the server its forwarding, on a client the relayed streams.
void Session::end_relayed(PeerId id) {
	if (is_relayed(id)) {
		_relayed.clear();
	}
	if (const auto channel = _relayer.remove_stream(id)) {
		const uint8_t content[] = { uint8_t(CloseRole::SENDER), uint8_t(*channel), uint8_t(*channel >> 8) };
		_relayer.visit_clients([&](PeerId client) {
			Peer &to = _peers.at(client);
			send(client, to, PacketKind::CLOSE, *to.relay_link, content, sizeof(content));
		});
	}
}

void Session::send_relayed() {
	_relayer.check_owners(_now, [this](PeerId owner, uint32_t body) { return is_unauthorized(owner, body); }, [this](PeerId owner) {
		_peers.at(owner).rejections.add(PacketError::UNAUTHORIZED_BODIES); });
	_relayer.flush(_now, MAX_SECTIONS, [this](PeerId client, const uint8_t *bytes, size_t size) {
		Peer &to = _peers.at(client);
		send(client, to, PacketKind::MOTION, *to.relay_link, bytes, size);
	});
}

void Session::advance_relayed(Peer &server) {
	_relayed.advance(_now, [this](PeerId owner, RelayedStreams::Stream &stream) { stream.unauthorized_bodies += count_unauthorized(owner, stream.receiver); });
	_relayed.send_acks(_now, MAX_SECTIONS, *server.stream, [&](const uint8_t *bytes, size_t size) { send(RelayedStreams::SERVER, server, PacketKind::ACK, server.link, bytes, size); });
}

/// Statistics of a relayed stream.
SessionStatistics Session::relayed_statistics(PeerId owner, double now) {
	SessionStatistics result;
	if (RelayedStreams::Stream *stream = _relayed.find(owner)) {
		result.received_bytes = stream->received.bytes_per_second(now);
		result.received_packets = stream->received.packets_per_second(now);
		result.loss = stream->receiver.statistics().loss;
		result.round_trip = stream->receiver.statistics().round_trip;
		result.playback_delay = stream->receiver.statistics().playback_delay;
		result.late = stream->receiver.statistics().late_windows;
		result.unauthorized = stream->unauthorized_bodies;
	}
	return result;
}

} // namespace net
