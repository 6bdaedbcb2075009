#include "net/session/session.hpp"

// The part of Session that relays streams.

namespace net {

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
		peer.request_stream(_now);
	}
	_relay = relay;
	set_settings(_settings);
	update_relay();
}

/// A client requests a relayed stream from the server, unless the server has said that it does not relay. If that changes, all
/// streams are requested anew.
void Session::update_relay() {
	const auto server = _peers.find(RelayedStreams::SERVER);
	const bool is_relayed = _relay && server != _peers.end() && server->second.relay.value_or(true);
	if (is_relayed == _is_link_relayed) {
		return;
	}
	for (auto &[id, peer] : _peers) {
		if (peer.is_open_sent()) {
			send_close(id, peer, peer.link, CloseRole::RECEIVER);
		}
		end_stream(id, peer);
		peer.request_stream(_now);
	}
	_is_link_relayed = is_relayed;
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
	_relayed_at = _running_time;
	_relayer.check_owners(_running_time, _owners, [this](PeerId owner, PacketError error) {
		_peers.at(owner).rejections.add(error);
		++_rejected;
	});
	_relayer.flush(_running_time, sender_settings().max_packet_size + Section::HEADER, [this](PeerId client, const uint8_t *bytes, size_t size) {
		Peer &to = _peers.at(client);
		send(client, to, PacketKind::MOTION, *to.relay_link, bytes, size);
		_has_forwarded = true;
	});
}

/// Advances the relayed streams and acknowledges what has arrived, with the server's own stream.
void Session::acknowledge_relayed(Peer &server) {
	_relayed.advance(_now, [this](PeerId owner, RelayedStreams::Stream &stream) { stream.unauthorized_bodies += _owners.count_unauthorized(owner, stream.receiver); });
	_relayed.send_acks(_now, sender_settings().max_packet_size + Section::HEADER, *server.stream, [&](const uint8_t *bytes, size_t size) { send(RelayedStreams::SERVER, server, PacketKind::ACK, server.link, bytes, size); });
}

} // namespace net
