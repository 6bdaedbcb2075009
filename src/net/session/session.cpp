#include "net/session/session.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace net {

namespace {

/// Seconds between two OPEN packets, until the stream arrives.
constexpr double OPEN_INTERVAL = 0.25;
/// After this many seconds without a packet, the owner may have lost the subscription: the receiver sends OPEN again.
constexpr double SILENCE = 1.0;
/// Minimum seconds between two subscriptions of a peer, so that it cannot make us start a stream every tick.
constexpr double SUBSCRIPTION_INTERVAL = 0.2;
/// Capacity for bodies that do not exist here yet. It bounds the memory that a peer can make us allocate.
constexpr size_t SPARE_BODIES = 4096;

/// Content of an OPEN for a relayed stream, and of those of a server that relays.
constexpr uint8_t OPEN_RELAY = 1;

/// All sessions of a process share one sequence, with a time-dependent start, so that packets of an earlier stream are not
/// mistaken for packets of a new one.
uint8_t next_link(double now) {
	static uint8_t last_link = uint8_t(int64_t(now * 1e3));
	return ++last_link;
}

} // namespace

void Session::connect(PeerId self, uint16_t key) {
	for (auto &[id, peer] : _peers) {
		end_stream(id, peer);
	}
	_relayer = Relay();
	_peers.clear();
	_connected.clear();
	_owners.clear();
	_body_count.clear();
	_sender.reset();
	_self = self;
	_key = key;
	_streams_stale = true;
}

std::vector<PeerId> Session::set_peers(const std::vector<PeerId> &peers, double now) {
	std::vector<PeerId> left;
	if (peers == _connected) {
		return left;
	}
	_now = now;
	std::set_difference(_connected.begin(), _connected.end(), peers.begin(), peers.end(), std::back_inserter(left));
	_connected = peers;
	for (const PeerId id : left) {
		unsubscribe(id, _peers[id]);
		end_stream(id, _peers[id]);
		_peers.erase(id);
	}
	for (const PeerId id : peers) {
		_peers.try_emplace(id);
	}
	_streams_stale = true;
	return left;
}

void Session::close(double now) {
	_now = now;
	for (auto &[id, peer] : _peers) {
		if (peer.subscribed) {
			send_close(id, peer, peer.subscription, CloseRole::SENDER);
		}
		if (peer.stream) {
			send_close(id, peer, peer.link, CloseRole::RECEIVER);
		}
	}
}

void Session::set_settings(const StreamSettings &settings) {
	const double tick = _settings.tick;
	_settings = settings;
	_settings.tick = tick;
	if (_sender) {
		_sender->set_settings(_settings);
	}
}

void Session::set_margin_limits(double min, double max) {
	_min_margin = min;
	_max_margin = max;
	_relayed.set_margin_limits(min, max);
	for (auto &[id, peer] : _peers) {
		if (peer.stream) {
			peer.stream->set_margin_limits(min, max);
		}
	}
}

void Session::count_owner(PeerId owner, int change) {
	size_t &count = _body_count[owner];
	count += size_t(change);
	if (count == 0) {
		_body_count.erase(owner);
	}
	_streams_stale = true;
}

void Session::set_owner(uint32_t body, PeerId owner) {
	remove_body(body);
	_owners[body] = owner;
	count_owner(owner, 1);
}

void Session::remove_body(uint32_t body) {
	const auto found = _owners.find(body);
	if (found == _owners.end()) {
		return;
	}
	if (found->second == _self && _sender) {
		_sender->remove_body(body);
	}
	count_owner(found->second, -1);
	_owners.erase(found);
}

void Session::begin_tick(double now, double length) {
	_now = _tick_time = now;
	if (length != _settings.tick) {
		// From here on, the session and its sender count whole ticks of the new length.
		_first_tick = time();
		_tick = 0;
		_settings.tick = length;
		if (_sender) {
			_sender->set_settings(_settings);
		}
	}
	_tick++;
}

bool Session::observe(uint32_t body, const cga::Pose<double> &pose) {
	if (!_sender || (!_sender->has_body(body) && !_sender->add_body(body, pose))) {
		return false;
	}
	return _sender->observe(body, time(), pose) || (_sender->observe(body, time()), false);
}

void Session::teleport(uint32_t body) {
	if (_sender) {
		_sender->teleport(body);
	}
}

void Session::end_tick() {
	if (_streams_stale) {
		update_streams();
	}
	if (_sender) {
		send_motion();
	}
	send_relayed();
}

void Session::send_motion() {
	_sender->flush(time());
	for (const OutgoingPacket &packet : _sender->packets()) {
		const auto id = PeerId(packet.receiver);
		Peer &peer = _peers[id];
		if (peer.relay_link) {
			_relayer.add_own_packet(id, _sender->bytes() + packet.begin, packet.size);
		} else {
			send(id, peer, PacketKind::MOTION, peer.subscription, _sender->bytes() + packet.begin, packet.size);
		}
	}
}

/// Opens a stream from each peer that owns a body, and closes the others.
void Session::update_streams() {
	_streams_stale = false;
	for (auto &[id, peer] : _peers) {
		const bool is_too_small = peer.max_bodies < _owners.size() + SPARE_BODIES / 2;
		const bool is_other_mode = id == RelayedStreams::SERVER && is_relay_client() != _is_link_relayed;
		if (peer.stream && (!wants_stream(id) || is_too_small || is_other_mode)) {
			close_stream(id, peer);
		}
		if (!peer.stream && wants_stream(id)) {
			open_stream(id, peer);
		}
	}
}

void Session::open_stream(PeerId id, Peer &peer) {
	peer.link = next_link(_now);
	peer.max_bodies = 2 * _owners.size() + SPARE_BODIES;
	peer.stream.emplace(peer.max_bodies);
	peer.stream->set_margin_limits(_min_margin, _max_margin);
	peer.open_due = 0.0;
	if (is_relaying()) {
		_relayer.add_stream(id, *peer.stream, _now);
	} else if (id == RelayedStreams::SERVER) {
		_is_link_relayed = is_relay_client();
	}
}

void Session::end_stream(PeerId id, Peer &peer) {
	if (peer.stream) {
		end_relayed(id, peer);
		_late += peer.stream->statistics().late_windows;
		peer.stream.reset();
		peer.ended_at = _now;
	}
}

void Session::close_stream(PeerId id, Peer &peer) {
	send_close(id, peer, peer.link, CloseRole::RECEIVER);
	end_stream(id, peer);
}

void Session::subscribe(PeerId id, Peer &peer, uint8_t link, double now) {
	const bool is_recent = now - peer.subscribed_at < SUBSCRIPTION_INTERVAL;
	if (peer.is_subscribed(link) || is_recent || !owns_bodies(_self)) {
		return; // the peer repeats the OPEN until a stream arrives
	}
	if (!_sender) {
		_sender.emplace(_settings);
	}
	if (peer.subscribed) {
		_sender->remove_receiver(uint32_t(id));
		peer.ended_at = now;
	}
	peer.subscribed = true;
	peer.subscription = link;
	peer.subscribed_at = now;
	_sender->add_receiver(uint32_t(id), time());
}

void Session::unsubscribe(PeerId id, Peer &peer) {
	stop_relaying_to(id, peer);
	if (!peer.subscribed) {
		return;
	}
	peer.subscribed = false;
	peer.ended_at = _now;
	_sender->remove_receiver(uint32_t(id));
	if (std::none_of(_peers.begin(), _peers.end(), [](const auto &entry) { return entry.second.subscribed; })) {
		_sender.reset();
	}
}

void Session::advance(double now) {
	_now = now;
	for (auto &[id, peer] : _peers) {
		if (!peer.stream) {
			continue;
		}
		peer.stream->advance(now);
		peer.unauthorized_bodies += count_unauthorized(id, *peer.stream);
		if (is_relayed(peer)) {
			advance_relayed(peer);
		} else {
			peer.stream->take_ack(_ack, now);
			if (!_ack.empty()) {
				send(id, peer, PacketKind::ACK, peer.link, _ack.data(), _ack.size());
			}
		}
		if (now >= peer.open_due) {
			peer.open_due = now + OPEN_INTERVAL;
			const bool relays = is_relaying() || is_relayed(peer);
			send(id, peer, PacketKind::OPEN, peer.link, &OPEN_RELAY, relays ? 1 : 0);
		}
	}
}

bool Session::is_unauthorized(PeerId owner, uint32_t body) const {
	const auto found = _owners.find(body);
	return found != _owners.end() && found->second != owner;
}

/// Returns the number of new bodies in a stream that its sender does not own. They are not shown. This is not an error: when a
/// body changes its owner, peers are notified at different times.
uint64_t Session::count_unauthorized(PeerId owner, Receiver &stream) {
	stream.take_events(_events);
	return uint64_t(std::count_if(_events.begin(), _events.end(), [&](const BodyEvent &event) { return event.kind == BodyEvent::ADDED && is_unauthorized(owner, event.id); }));
}

const Receiver *Session::stream(PeerId peer) const {
	const auto found = _peers.find(peer);
	const RelayedStreams::Stream *relayed = _relayed.find(peer);
	const Receiver *stream = found != _peers.end() && found->second.stream ? &*found->second.stream : relayed != nullptr ? &relayed->receiver : nullptr;
	return stream != nullptr && stream->is_ready() ? stream : nullptr;
}

double Session::media_time(PeerId peer) const {
	if (peer == _self) {
		return _sender ? _sender->media_time(time()) : 0.0;
	}
	const Receiver *receiver = stream(peer);
	return receiver != nullptr ? receiver->media_time() : 0.0;
}

void Session::send(PeerId id, Peer &peer, PacketKind kind, uint8_t link, const uint8_t *bytes, size_t size) {
	uint8_t *packet = _outbox.add(id, kind == PacketKind::CLOSE, ENVELOPE_BYTES + size);
	write_envelope({ kind, _key, link, ENVELOPE_VERSION }, packet);
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
	if (!envelope || envelope->key != _key || found == _peers.end()) {
		return;
	}
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
		result = accept_motion(peer, envelope->link, bytes, size, now);
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
	if (is_for_relay && is_relaying()) {
		relay_to(id, peer, link);
	}
	if (!is_for_relay || is_relaying() || id == RelayedStreams::SERVER) {
		subscribe(id, peer, link, now);
	}
	return result;
}

PacketResult Session::accept_motion(Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	if (!peer.has_stream(link)) {
		if (peer.ended_recently(now)) {
			return {};
		}
		return peer.stream ? PacketError::STREAM_NOT_REQUESTED : PacketError::SENDER_OWNS_NOTHING;
	}
	const PacketResult result = is_relayed(peer) ? _relayed.accept(_self, bytes, size, now, *peer.stream) : peer.stream->accept(bytes, size, now);
	if (result) {
		peer.open_due = now + SILENCE;
	}
	return result;
}

PacketResult Session::accept_ack(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now) {
	// Add the time since the last tick. Otherwise round trips would be measured in whole ticks.
	const double since_tick = std::clamp(now - _tick_time, 0.0, _settings.tick);
	const auto accept_own = [&](const uint8_t *own, size_t own_size) {
		return peer.is_subscribed(link) ? _sender->accept(uint32_t(id), own, own_size, time() + since_tick) : PacketResult();
	};
	if (peer.relay_link == link) {
		return _relayer.accept(id, bytes, size, now, accept_own);
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
		if (peer.has_stream(link) && is_relayed(peer)) {
			_relayed.end(uint32_t(bytes[1] | bytes[2] << 8), _now);
		}
	} else if (role == CloseRole::SENDER && peer.has_stream(link)) {
		// The sender may return: request a new stream until it does.
		end_stream(id, peer);
		_streams_stale = true;
	} else if (role == CloseRole::RECEIVER && (peer.is_subscribed(link) || peer.relay_link == link)) {
		unsubscribe(id, peer);
	}
	return {};
}

SessionStatistics Session::statistics(PeerId id, double now) {
	SessionStatistics result = relayed_statistics(id, now);
	const auto found = _peers.find(id);
	if (found != _peers.end()) {
		result.add(direct_statistics(id, found->second, now));
	}
	return result;
}

/// Statistics of a peer, without those of its stream if that is relayed.
SessionStatistics Session::direct_statistics(PeerId id, Peer &peer, double now) {
	SessionStatistics result = peer.statistics(now);
	if (peer.subscribed) {
		const ReceiverStatistics receiver = _sender->statistics(uint32_t(id));
		result.loss = std::max(result.loss, receiver.loss);
		result.round_trip = std::max(result.round_trip, receiver.round_trip);
	}
	return result;
}

SessionStatistics Session::total_statistics(double now) {
	SessionStatistics total;
	for (auto &[id, peer] : _peers) {
		total.add(direct_statistics(id, peer, now));
	}
	_relayed.visit([&](PeerId owner, const RelayedStreams::Stream &) {
		SessionStatistics relayed = relayed_statistics(owner, now);
		relayed.received_bytes = relayed.received_packets = 0.0; // those of the server include them
		total.add(relayed);
	});
	total.late += _late + _relayed.ended_late();
	total.rejected = _rejected;
	return total;
}

} // namespace net
