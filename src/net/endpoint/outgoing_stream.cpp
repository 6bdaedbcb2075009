#include "net/endpoint/outgoing_stream.hpp"

#include "net/coding/portable_math.hpp"
#include "net/stream/snapshot_header.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace net {

namespace {

/// Maximum length of a window in which nothing moves, in seconds. Such windows serve as keep-alives.
constexpr double IDLE_WINDOW = 0.5;
/// Maximum length of any other window, in seconds: receivers request a snapshot after 1.5 s without one.
constexpr double MAX_WINDOW = 1.0;
/// Minimum fraction of max_latency reserved for the window, regardless of network conditions.
constexpr double MIN_WINDOW = 0.4;
/// Above this loss, windows are shortened to leave time for a retransmission.
constexpr double NOTABLE_LOSS = 0.004;
/// Windows are shortened to about this many chunks, so that few are in flight, but not below this many ticks, as each costs work for each
/// body.
constexpr double MAX_WINDOW_CHUNKS = 24.0;
constexpr double MIN_WINDOW_TICKS = 3.0;
/// Rounding error of times, in ticks.
constexpr double SAME_TIME = 1e-5;

/// Windows are short for this many seconds after a peer has joined, until its line is known.
constexpr double MAX_UNKNOWN_TIME = 1.0;

/// The part of a line's rate that the stream uses, and the part that it uses at least, even if much waits to be sent.
constexpr double USABLE_RATE = 0.8;
constexpr double MIN_RATE_SHARE = 0.4;
/// Bytes per second of a line whose rate is not known yet, but which loses much of its first snapshot.
constexpr double LOSING_RATE = 5e3;
/// Seconds in which what waits to be sent is to be sent.
constexpr double DRAIN_TIME = 1.0;
/// Above so many octaves, windows become longer with each, as errors would grow much for few bytes.
constexpr double UNSTRETCHED_OCTAVES = 5.0;
constexpr double STRETCH_PER_OCTAVE = 0.5;
/// How fast errors grow and shrink, in octaves per second: proportionally to the octaves by which the stream's rate is too high, at most RELAX
/// and TIGHTEN.
constexpr double RELAX_PER_OCTAVE = 3.0;
constexpr double RELAX = 6.0;
constexpr double TIGHTEN = 1.0;

} // namespace

void OutgoingStream::start(double begin, double now) {
	_window_begin = int64_t(std::ceil(begin));
	_encoder.emplace(float(_settings.position_tolerance), float(_settings.rotation_tolerance), _settings.mode);
	for (auto &peer : _peers) {
		peer.second.delivery.restart(now);
	}
	_changed_since = -1;
	_relaxation = 0.0;
	_is_starting = true;
}

double OutgoingStream::network_time(const Peer &peer, double now) const {
	const Delivery &delivery = peer.delivery;
	if (delivery.is_silent(now) || (!delivery.congestion().is_validated() && now - peer.joined_at > MAX_UNKNOWN_TIME)) {
		return 0.0;
	}
	return std::max(3.0 * delivery.round_trip_deviation(), FRAME) + (delivery.expected_loss() > NOTABLE_LOSS ? delivery.rto() + _settings.tick : 0.0);
}

double OutgoingStream::waiting_time(const Peer &peer) const {
	const CongestionControl &congestion = peer.delivery.congestion();
	return congestion.is_validated() && congestion.is_limiting() ? double(peer.delivery.backlog(_ring)) / congestion.delivered_rate() : 0.0;
}

double OutgoingStream::max_window(double now) const {
	double network = FRAME;
	for (const auto &peer : _peers) {
		network = std::max(network, network_time(peer.second, now));
	}
	// While the chunks of a window are sent, the next window begins.
	const double spread = _ring.rate() / (_ring.rate() + Delivery::MAX_BURST / _settings.tick);
	const double longest = std::max((_settings.max_latency - network) / (1.0 + spread), _settings.max_latency * MIN_WINDOW);
	const double stretch = 1.0 + STRETCH_PER_OCTAVE * std::max(_relaxation - UNSTRETCHED_OCTAVES, 0.0);
	return std::clamp(stretch * std::min(1.0 / _settings.send_rate, _settings.max_latency), std::min(stretch * longest, MAX_WINDOW), MAX_WINDOW) / _settings.tick;
}

bool OutgoingStream::is_window_due(const Flush &flush) const {
	const double next = double(flush.tick) + flush.step;
	if (next - double(_window_begin) > double(MAX_TICKS) + SAME_TIME) {
		return true;
	}
	if (std::any_of(_peers.begin(), _peers.end(), [](const auto &peer) { return peer.second.delivery.needs_snapshot(); })) {
		return true;
	}
	const double longer = next - double(_window_begin);
	if (longer > MIN_WINDOW_TICKS + SAME_TIME && _chunks_per_tick * longer > MAX_WINDOW_CHUNKS) {
		return true;
	}
	const double max_ticks = max_window(flush.now);
	const bool is_aligned = flush.grid && flush.grid->ends_window(double(_window_begin), double(flush.tick), max_ticks);
	if (_changed_since >= 0) {
		return is_aligned || next - double(_changed_since) > max_ticks + SAME_TIME;
	}
	// The next aligned end would be too late.
	const double following = is_aligned ? double(flush.tick) + flush.grid->period : next;
	return following - double(_window_begin) > IDLE_WINDOW / _settings.tick;
}

uint32_t OutgoingStream::oldest_needed(double now) const {
	uint32_t oldest = _ring.next();
	for (const auto &peer : _peers) {
		const Delivery &delivery = peer.second.delivery;
		oldest = delivery.is_silent(now) || delivery.needs_snapshot() ? oldest : std::min(oldest, delivery.first_missing());
	}
	return oldest;
}

void OutgoingStream::close_window(int64_t end, double now) {
	while (_window_begin < end) {
		const int length = int(std::min<int64_t>(end - _window_begin, MAX_TICKS));
		const uint32_t first_chunk = _ring.next();
		_window.clear();
		_encoder->encode_window(double(_window_begin), length, _window);
		_ring.push_window(_window, _encoder->check(), length * _settings.tick, _settings.max_packet_size, oldest_needed(now));
		_chunks_per_tick = double(_ring.next() - first_chunk) / length;
		_window_begin += length;
		adapt(length * _settings.tick, now);
	}
	_changed_since = _encoder->has_changes() ? _window_begin : -1;
}

/// Bytes per second that the stream should have, so that all lines carry it and what waits for them is sent; infinite if no line limits it.
double OutgoingStream::carried_rate(double now) const {
	double carried = std::numeric_limits<double>::infinity();
	for (const auto &entry : _peers) {
		const Delivery &delivery = entry.second.delivery;
		const CongestionControl &line = delivery.congestion();
		if (delivery.is_silent(now)) {
			continue;
		}
		if (!line.is_validated() || !line.is_limiting()) {
			carried = delivery.is_losing_snapshot() ? std::min(carried, LOSING_RATE) : carried;
			continue;
		}
		const double spare = USABLE_RATE * line.delivered_rate() - double(delivery.backlog(_ring)) / DRAIN_TIME;
		carried = std::min(carried, std::max(spare, MIN_RATE_SHARE * line.delivered_rate()));
	}
	return carried;
}

/// Lets errors grow or shrink, after a window of `seconds`, so that the lines carry the stream.
void OutgoingStream::adapt(double seconds, double now) {
	constexpr double MAX_RELAXATION = BodyState::MAX_COARSENESS + 0.9;
	constexpr double MAX_RATIO = 1e6;
	// All machines compute the same coarseness from the same acknowledgements.
	const double excess = portable_log2(std::clamp(_ring.rate() / std::max(carried_rate(now), 1.0), 1.0 / MAX_RATIO, MAX_RATIO));
	_relaxation = std::clamp(_relaxation + std::clamp(excess * RELAX_PER_OCTAVE, -TIGHTEN, RELAX) * seconds, 0.0, MAX_RELAXATION);
	_encoder->set_coarseness(int(_relaxation));
}

void OutgoingStream::start_snapshots(const Flush &flush) {
	std::shared_ptr<Snapshot> snapshot;
	for (auto &peer : _peers) {
		Delivery &delivery = peer.second.delivery;
		if (!delivery.needs_snapshot() || delivery.is_silent(flush.now)) {
			continue;
		}
		if (snapshot == nullptr) {
			snapshot = std::make_shared<Snapshot>();
			snapshot->number = ++flush.snapshot_number;
			snapshot->next_chunk = _ring.next();
			snapshot->fragment_size = Snapshot::fragment_size_for(_settings.max_packet_size);
			SnapshotHeader header;
			header.settings = _settings;
			header.tick = uint64_t(_window_begin);
			header.window = float(max_window(flush.now) * _settings.tick);
			put_snapshot_header(snapshot->bytes, header);
			_encoder->encode_snapshot(snapshot->bytes);
		}
		delivery.start_snapshot(snapshot);
	}
}

void OutgoingStream::flush(const Flush &flush) {
	if (_is_starting && flush.tick >= _window_begin) {
		_encoder->start_at(double(_window_begin));
		start_snapshots(flush);
		_is_starting = false;
	}
	if (_changed_since < 0 && _encoder->has_changes()) {
		// Close the idle window at once, so that the window with the motion can be short.
		close_window(std::max(_window_begin, std::min(flush.previous_tick, flush.tick - 1)), flush.now);
		_changed_since = _window_begin;
	}
	if (flush.tick > _window_begin && is_window_due(flush)) {
		close_window(flush.tick, flush.now);
		start_snapshots(flush);
	}
}

void OutgoingStream::send(double now, std::vector<uint8_t> &bytes, std::vector<OutgoingPacket> &packets) {
	// By default, receivers delay playback by up to twice max_latency from the begin of a window.
	const double max_wait = 2.0 * _settings.max_latency - max_window(now) * _settings.tick;
	for (auto &entry : _peers) {
		Peer &peer = entry.second;
		peer.delivery.set_max_wait(max_wait);
		peer.delivery.set_snapshot_size(Snapshot::estimate(_encoder->body_count()));
		peer.delivery.send(_ring, now, _settings.max_packet_size, bytes, [&](size_t begin, size_t size) {
			packets.push_back({ entry.first, begin, size });
			peer.bytes_sent += size;
			++peer.packets_sent;
		});
	}
}

} // namespace net
