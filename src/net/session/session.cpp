#include "net/session/session.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace net {

namespace {

/// Minimum seconds between two subscriptions of a peer, so that it cannot make us start a stream every tick.
constexpr double SUBSCRIPTION_INTERVAL = 0.2;
/// A peer that owns no more bodies keeps its streams open for this many seconds and twice max_latency, so that receivers play them
/// to their end.
constexpr double LINGER = 2.0;
/// After this many ticks that were due, but have not begun, a server relays without them.
constexpr double MAX_TICKS_MISSED = 2.5;
/// If two calls are farther apart than this, in seconds, the process stood still: packets waited, although the network was fast.
constexpr double MAX_STEP = 0.25;
/// Maximum time in seconds for which a server that relays holds back acknowledgements.
constexpr double MAX_ACK_HOLD = 0.05;

/// The game does not choose the tick length together with max_latency.
StreamSettings limited_latency(StreamSettings settings) {
	settings.max_latency = std::min(settings.max_latency, MAX_LATENCY_TICKS * settings.tick);
	return settings;
}

} // namespace

double Session::set_now(double now) {
	const double before = std::exchange(_now, _clock.advance(now));
	_running_time += std::clamp(_now - before, 0.0, MAX_STEP);
	return _now;
}

void Session::connect(PeerId self) {
	for (auto &[id, peer] : _peers) {
		end_stream(id, peer);
	}
	_relayer = Relay();
	_is_link_relayed = false;
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
		end_stream(id, _peers[id]);
		_peers.erase(id);
	}
	for (const PeerId id : peers) {
		const auto [entry, is_new] = _peers.try_emplace(id);
		if (is_new) {
			entry->second.request_stream(_now);
		}
	}
	update_relay();
	return left;
}

void Session::close(double now) {
	set_now(now);
	for (auto &[id, peer] : _peers) {
		if (peer.subscribed || peer.relay_link) {
			send_close(id, peer, peer.relay_link.value_or(peer.subscription), CloseRole::SENDER);
		}
		if (peer.is_open_sent()) {
			send_close(id, peer, peer.link, CloseRole::RECEIVER);
		}
	}
}

bool Session::set_settings(StreamSettings settings) {
	settings.tick = _settings.tick;
	if (!limited_latency(settings).is_valid()) {
		return false;
	}
	_settings = settings;
	if (_sender) {
		_sender->set_settings(sender_settings());
	}
	return true;
}

StreamSettings Session::sender_settings() const {
	StreamSettings settings = limited_latency(_settings);
	const size_t size = std::clamp(std::min(settings.max_packet_size, _size_limit), StreamSettings::MIN_PACKET_SIZE, StreamSettings::MAX_PACKET_SIZE);
	settings.max_packet_size = size - ENVELOPE_BYTES - ENGINE_HEADER - (_relay ? Section::HEADER : 0);
	return settings;
}

size_t Session::packet_refused(PeerId peer, size_t size) {
	const size_t limit = std::max(size / 4 * 3, StreamSettings::MIN_PACKET_SIZE);
	if (has_peer(peer) && size > StreamSettings::MIN_PACKET_SIZE) {
		_size_limit = std::min(limit, _size_limit);
		_relayer.resend_all(peer);
		if (_sender) {
			_sender->set_settings(sender_settings());
			_sender->resend_all(uint32_t(peer));
		}
	}
	return std::clamp(std::min(_settings.max_packet_size, _size_limit), StreamSettings::MIN_PACKET_SIZE, StreamSettings::MAX_PACKET_SIZE);
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

void Session::set_owner(uint32_t body, PeerId owner) {
	if (_owners.find(body) == owner) {
		return;
	}
	remove_body(body);
	_owners.set(body, owner);
	if (owner == _self) {
		++_owned;
		start_requested();
	}
}

void Session::remove_body(uint32_t body, bool freed) {
	if (_owners.find(body) == _self) {
		--_owned;
		if (_sender) {
			_sender->remove_body(body, freed);
		}
	}
	_owners.remove(body);
}

void Session::begin_tick(double now, double length) {
	set_now(now);
	length = length > 0.0 ? std::clamp(length, TICK_RANGE.min, TICK_RANGE.max) : _settings.tick;
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
	if (!_sender) {
		return false;
	}
	if (!_sender->has_body(body)) {
		if (!_sender->add_body(body, pose, planar, time())) {
			return false;
		}
		_sender->set_priority(body, _owners.priority(body));
	}
	return _sender->observe(body, time(), pose) || (_sender->observe(body, time()), false);
}

void Session::teleport(uint32_t body) {
	if (_sender) {
		_sender->teleport(body);
	}
}

bool Session::set_priority(uint32_t body, int priority) {
	if (_owners.find(body) != _self) {
		return false;
	}
	_owners.set_priority(body, priority);
	if (_sender) {
		_sender->set_priority(body, priority);
	}
	return true;
}

void Session::end_tick() {
	if (is_relaying()) {
		// Not the longest windows that Sender makes: owners on a varying network should not have to divide the period.
		const double window = std::max(_settings.max_latency - 2.0 * FRAME, _settings.send_rate > 0.0 ? std::min(1.0 / _settings.send_rate, _settings.max_latency) : 0.0);
		_relayer.begin_tick(_tick, _running_time, _settings.tick, window);
		if (_sender) {
			_sender->align(time() - double(_relayer.schedule().ticks_since_instant()) * _settings.tick, _relayer.schedule().period());
		}
	}
	if (_sender) {
		send_motion();
		_owned_at = _owned > 0 ? _now : _owned_at;
		// Receivers then request new streams.
		for (auto &[id, peer] : _peers) {
			if (_now - _owned_at > LINGER + 2.0 * _settings.max_latency && peer.subscribed && !peer.relay_link) {
				close_subscription(id, peer);
			}
		}
	}
	send_relayed();
}

void Session::send_motion() {
	_sender->flush(time(), _running_time);
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

/// Ends our stream to a peer that may request it again.
void Session::close_subscription(PeerId id, Peer &peer) {
	if (peer.subscribed || peer.relay_link) {
		send_close(id, peer, peer.relay_link.value_or(peer.subscription), CloseRole::SENDER);
	}
	peer.requested.reset();
	unsubscribe(id, peer);
}

void Session::end_stream(PeerId id, Peer &peer) {
	end_relayed(id);
	if (peer.stream) {
		_late += peer.stream->statistics().late_windows;
		peer.stream.reset();
		peer.note_end(peer.link, _now);
	}
}

/// Starts the streams that peers have requested, if there are bodies to send.
void Session::start_requested() {
	for (auto &[id, peer] : _peers) {
		if (is_relaying() && peer.relay == true && peer.requested && peer.relay_link != peer.requested && _now - peer.relayed_at >= SUBSCRIPTION_INTERVAL) {
			if (peer.relay_link) {
				peer.note_end(*peer.relay_link, _now);
			}
			peer.relay_link = peer.requested;
			peer.relayed_at = _now;
			_relayer.add_client(id, _running_time);
		}
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
		peer.note_end(peer.subscription, _now);
	}
	peer.subscribed = true;
	peer.subscription = *peer.requested;
	peer.subscribed_at = _now;
	_sender->add_receiver(uint32_t(id), time(), _running_time);
}

void Session::unsubscribe(PeerId id, Peer &peer) {
	if (peer.relay_link) {
		peer.note_end(*peer.relay_link, _now);
		peer.relay_link.reset();
		_relayer.remove_client(id);
	}
	if (!peer.subscribed) {
		return;
	}
	peer.subscribed = false;
	peer.note_end(peer.subscription, _now);
	_sender->remove_receiver(uint32_t(id));
	if (std::none_of(_peers.begin(), _peers.end(), [](const auto &entry) { return entry.second.subscribed; })) {
		_sender.reset();
	}
}

void Session::advance(double now) {
	now = set_now(now);
	const bool has_forwarded = std::exchange(_has_forwarded, false);
	for (auto &[id, peer] : _peers) {
		if (peer.stream) {
			peer.limit_work(_owners.expected(id), now);
			const PacketResult result = peer.stream->decode_waiting(now);
			if (!result) {
				peer.rejections.add(result.error(), peer.stream->other_version());
				++_rejected;
			}
			end_if_refused(id, peer, result);
		}
		if (peer.stream) {
			peer.stream->advance(now);
			peer.unauthorized_bodies += _owners.count_unauthorized(id, *peer.stream);
		}
		if (peer.stream && is_relayed(id)) {
			acknowledge_relayed(peer);
		} else if (peer.stream && (has_forwarded || !peer.relay_link || now - peer.acked_at >= MAX_ACK_HOLD)) {
			// A server that relays acknowledges when it forwards, so that both travel in one datagram.
			peer.acked_at = now;
			peer.stream->take_ack(_ack, now);
			if (const auto alignment = _relayer.take_alignment(id, _running_time)) {
				put_alignment(_ack, *alignment);
			}
			if (!_ack.empty()) {
				send(id, peer, PacketKind::ACK, peer.link, _ack.data(), _ack.size());
			}
		}
		const bool is_wanted = !_is_link_relayed || is_relayed(id);
		if (is_wanted && peer.open.is_due(now)) {
			peer.open.back_off(now);
			++peer.opens_sent;
			peer.opened_at = now;
			send_open(id, peer, peer.link, 0, 0);
		}
	}
	if (is_relaying() && _running_time - _relayed_at > MAX_TICKS_MISSED * _settings.tick) {
		send_relayed(); // although we make no ticks, owners do
	}
}

const Receiver *Session::stream(PeerId peer) const {
	const Receiver *stream = nullptr;
	if (const auto found = _peers.find(peer); found != _peers.end() && found->second.stream) {
		stream = &*found->second.stream;
	} else if (const RelayedStreams::Stream *relayed = _relayed.find(peer)) {
		stream = &relayed->receiver;
	}
	return stream != nullptr && stream->is_ready() ? stream : nullptr;
}

size_t Session::stream_size(PeerId peer) const {
	if (const Receiver *receiver = stream(peer)) {
		return receiver->stream_size();
	}
	const auto found = _peers.find(peer);
	return found != _peers.end() ? found->second.refused_size : 0;
}

double Session::media_time(PeerId peer) const {
	if (peer == _self) {
		return _sender ? _sender->media_time(time()) : 0.0;
	}
	const Receiver *receiver = stream(peer);
	return receiver != nullptr ? receiver->media_time() : 0.0;
}

SessionStatistics Session::statistics(PeerId id, double now) {
	now = _clock.advance(now);
	SessionStatistics result = _relayed.statistics(id, now);
	const auto found = _peers.find(id);
	if (found != _peers.end()) {
		result.add(found->second.statistics(now, _sender ? _sender->statistics(uint32_t(id)) : ReceiverStatistics()));
	}
	return result;
}

SessionStatistics Session::total_statistics(double now) {
	now = _clock.advance(now);
	SessionStatistics total = _relayed.total_statistics(now);
	for (auto &[id, peer] : _peers) {
		total.add(peer.statistics(now, _sender ? _sender->statistics(uint32_t(id)) : ReceiverStatistics()));
	}
	total.late += _late;
	total.rejected = _rejected;
	return total;
}

} // namespace net
