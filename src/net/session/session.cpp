#include "net/session/session.hpp"

#include <algorithm>
#include <iterator>

namespace net {

namespace {

/// Minimum seconds between two subscriptions of a peer, so that it cannot make us start a stream every tick.
constexpr double SUBSCRIPTION_INTERVAL = 0.2;
/// A peer that owns no more bodies keeps its streams open for this many seconds and twice max_latency, so that receivers play them
/// to their end.
constexpr double LINGER = 2.0;
/// If two calls are farther apart than this, in seconds, the process stood still: packets waited, although the network was fast.
constexpr double MAX_STEP = 0.25;

/// All sessions of a process share one sequence, with a time-dependent start, so that packets of an earlier stream are not
/// mistaken for packets of a new one.
uint8_t next_link(double now) {
	static uint8_t last_link = uint8_t(int64_t(now * 1e3));
	return ++last_link;
}

} // namespace

void Session::set_now(double now) {
	_running_time += std::clamp(now - _now, 0.0, MAX_STEP);
	_now = now;
}

void Session::connect(PeerId self) {
	for (auto &[id, peer] : _peers) {
		end_stream(peer);
	}
	_peers.clear();
	_connected.clear();
	_owners.clear();
	_owned = 0;
	_size_limit = StreamSettings::MAX_PACKET_SIZE;
	_sender.reset();
	_self = self;
}

std::vector<PeerId> Session::set_peers(const std::vector<PeerId> &peers, double now) {
	std::vector<PeerId> left;
	if (peers == _connected) {
		return left;
	}
	set_now(now);
	std::set_difference(_connected.begin(), _connected.end(), peers.begin(), peers.end(), std::back_inserter(left));
	_connected = peers;
	for (const PeerId id : left) {
		unsubscribe(id, _peers[id]);
		end_stream(_peers[id]);
		_peers.erase(id);
	}
	for (const PeerId id : peers) {
		const auto [entry, is_new] = _peers.try_emplace(id);
		if (is_new) {
			request_stream(entry->second);
		}
	}
	return left;
}

void Session::close(double now) {
	set_now(now);
	for (auto &[id, peer] : _peers) {
		if (peer.subscribed) {
			send_close(id, peer, peer.subscription, CloseRole::SENDER);
		}
		send_close(id, peer, peer.link, CloseRole::RECEIVER);
	}
}

void Session::set_settings(const StreamSettings &settings) {
	const double tick = _settings.tick;
	_settings = settings;
	_settings.tick = tick;
	if (_sender) {
		_sender->set_settings(sender_settings());
	}
}

StreamSettings Session::sender_settings() const {
	StreamSettings settings = _settings;
	const size_t size = std::clamp(std::min(settings.max_packet_size, _size_limit), StreamSettings::MIN_PACKET_SIZE, StreamSettings::MAX_PACKET_SIZE);
	settings.max_packet_size = size - ENVELOPE_BYTES - ENGINE_HEADER;
	return settings;
}

size_t Session::packet_refused(PeerId peer, size_t size) {
	const size_t limit = std::max(size / 4 * 3, StreamSettings::MIN_PACKET_SIZE);
	if (has_peer(peer) && size > StreamSettings::MIN_PACKET_SIZE) {
		_size_limit = std::min(limit, _size_limit);
		if (_sender) {
			_sender->set_settings(sender_settings());
			_sender->resend_all(uint32_t(peer));
		}
	}
	return sender_settings().max_packet_size + ENVELOPE_BYTES + ENGINE_HEADER;
}

void Session::set_margin_limits(double min, double max) {
	_min_margin = min;
	_max_margin = max;
	for (auto &[id, peer] : _peers) {
		if (peer.stream) {
			peer.stream->set_margin_limits(min, max);
		}
	}
}

void Session::set_owner(uint32_t body, PeerId owner) {
	const auto found = _owners.find(body);
	if (found != _owners.end() && found->second == owner) {
		return;
	}
	remove_body(body);
	_owners[body] = owner;
	if (owner == _self) {
		++_owned;
		start_requested();
	}
}

void Session::remove_body(uint32_t body, bool freed) {
	const auto found = _owners.find(body);
	if (found == _owners.end()) {
		return;
	}
	if (found->second == _self) {
		--_owned;
		if (_sender) {
			_sender->remove_body(body, freed);
		}
	}
	_owners.erase(found);
}

void Session::begin_tick(double now, double length) {
	set_now(now);
	if (length != _settings.tick) {
		// From here on, the session and its sender count whole ticks of the new length.
		_first_tick = time();
		_tick = 0;
		_settings.tick = length;
		if (_sender) {
			_sender->set_settings(sender_settings());
		}
	}
	start_requested(); // with media time before this tick, so that this tick is sent at once
	_tick++;
}

bool Session::observe(uint32_t body, const cga::Pose<double> &pose, bool planar) {
	if (!_sender || (!_sender->has_body(body) && !_sender->add_body(body, pose, planar, time()))) {
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
	if (_sender) {
		send_motion();
		close_unneeded();
	}
}

void Session::send_motion() {
	_sender->flush(time(), _running_time);
	for (const OutgoingPacket &packet : _sender->packets()) {
		Peer &peer = _peers[PeerId(packet.receiver)];
		send(PeerId(packet.receiver), peer, PacketKind::MOTION, peer.subscription, _sender->bytes() + packet.begin, packet.size);
	}
}

/// Closes the outgoing streams some time after the last own body was removed. Their receivers then request new ones.
void Session::close_unneeded() {
	if (_owned > 0) {
		_owned_at = _now;
	} else if (_now - _owned_at > LINGER + 2.0 * _settings.max_latency) {
		for (auto &[id, peer] : _peers) {
			if (peer.subscribed) {
				send_close(id, peer, peer.subscription, CloseRole::SENDER);
				peer.requested.reset();
				unsubscribe(id, peer);
			}
		}
	}
}

void Session::request_stream(Peer &peer) {
	peer.link = next_link(_now);
	peer.open.restart(_now);
}

void Session::end_stream(Peer &peer) {
	if (peer.stream) {
		_late += peer.stream->statistics().late_windows;
		peer.stream.reset();
		peer.ended_at = _now;
	}
}

/// Closes a stream with too many bodies and requests it again later.
void Session::refuse_stream(PeerId id, Peer &peer) {
	const size_t size = peer.stream->stream_size();
	send_close(id, peer, peer.link, CloseRole::RECEIVER);
	end_stream(peer);
	request_stream(peer);
	peer.refused_size = size;
	peer.open.restart(_now + peer.refusal_pause);
	peer.refusal_pause = std::min(2.0 * peer.refusal_pause, Peer::MAX_REFUSAL_PAUSE);
}

void Session::accept_open(PeerId id, Peer &peer, uint8_t link, double now) {
	if (peer.requested != link) {
		peer.requested = link;
		if (stream(id) == nullptr && peer.refused_size == 0) {
			// The peer's session may be newer than our last request.
			peer.open.restart(now);
		}
	}
	start_requested();
}

/// Starts the streams that peers have requested, if there are bodies to send.
void Session::start_requested() {
	for (auto &[id, peer] : _peers) {
		const bool is_recent = _now - peer.subscribed_at < SUBSCRIPTION_INTERVAL;
		if (_owned > 0 && peer.requested && !peer.is_subscribed(*peer.requested) && !is_recent) {
			start_stream(id, peer);
		}
	}
}

void Session::start_stream(PeerId id, Peer &peer) {
	if (!_sender) {
		_sender.emplace(sender_settings());
	}
	if (peer.subscribed) {
		_sender->remove_receiver(uint32_t(id));
		peer.ended_at = _now;
	}
	peer.subscribed = true;
	peer.subscription = *peer.requested;
	peer.subscribed_at = _now;
	_sender->add_receiver(uint32_t(id), time(), _running_time);
}

void Session::unsubscribe(PeerId id, Peer &peer) {
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
	set_now(now);
	for (auto &[id, peer] : _peers) {
		if (peer.stream) {
			peer.stream->advance(now);
			count_unauthorized(id, peer);
			peer.stream->take_ack(_ack, now);
			if (!_ack.empty()) {
				send(id, peer, PacketKind::ACK, peer.link, _ack.data(), _ack.size());
			}
		}
		if (peer.open.is_due(now)) {
			peer.open.back_off(now);
			send(id, peer, PacketKind::OPEN, peer.link, nullptr, 0);
		}
	}
}

/// Bodies in the stream of a peer that does not own them are not shown. This is not an error: when a body changes its owner,
/// peers are notified at different times.
void Session::count_unauthorized(PeerId id, Peer &peer) {
	peer.stream->take_events(_events);
	for (const BodyEvent &event : _events) {
		const auto owner = _owners.find(event.id);
		if (event.kind == BodyEvent::ADDED && owner != _owners.end() && owner->second != id) {
			peer.unauthorized_bodies++;
		}
	}
}

const Receiver *Session::stream(PeerId peer) const {
	const auto found = _peers.find(peer);
	return found != _peers.end() && found->second.stream && found->second.stream->is_ready() ? &*found->second.stream : nullptr;
}

size_t Session::stream_size(PeerId peer) const {
	const auto found = _peers.find(peer);
	if (found == _peers.end()) {
		return 0;
	}
	return found->second.stream && found->second.stream->is_ready() ? found->second.stream->stream_size() : found->second.refused_size;
}

double Session::media_time(PeerId peer) const {
	if (peer == _self) {
		return _sender ? _sender->media_time(time()) : 0.0;
	}
	const Receiver *receiver = stream(peer);
	return receiver != nullptr ? receiver->media_time() : 0.0;
}

SessionStatistics Session::statistics(PeerId id, double now) {
	const auto found = _peers.find(id);
	if (found == _peers.end()) {
		return {};
	}
	SessionStatistics result = found->second.statistics(now);
	if (found->second.subscribed) {
		const ReceiverStatistics receiver = _sender->statistics(uint32_t(id));
		result.loss = std::max(result.loss, receiver.loss);
		result.round_trip = std::max(result.round_trip, receiver.round_trip);
	}
	return result;
}

SessionStatistics Session::total_statistics(double now) {
	SessionStatistics total;
	for (const auto &entry : _peers) {
		total.add(statistics(entry.first, now));
	}
	total.late += _late;
	total.rejected = _rejected;
	return total;
}

} // namespace net
