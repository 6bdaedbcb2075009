#include "net/endpoint/sender.hpp"

#include "net/stream/snapshot_header.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

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
/// Upper bound of the estimated step between two flushes, in ticks. Longer steps are pauses.
constexpr double MAX_STEP = 4.0;
/// Windows are shortened to about this many chunks, so that few are in flight.
constexpr double MAX_WINDOW_CHUNKS = 24.0;
/// Rounding error of times, in ticks.
constexpr double SAME_TIME = 1e-5;
/// A time this short of a tick counts as that tick: recorded times are rounded.
constexpr double SAME_TICK = 0.01;

/// After a pause of more than this, in ticks, the stream goes on with a snapshot, as the windows of the pause would take too long.
constexpr int64_t MAX_PAUSE = int64_t(64) * MAX_TICKS;
/// Beyond this tick, the stream starts anew: a double holds ticks and fractions of 1/4096 up to it.
constexpr int64_t LAST_TICK = int64_t(1) << 40;
/// Minimum seconds between two requests to align windows.
constexpr double MIN_ALIGN_INTERVAL = 0.2;

/// A pseudorandom number, determined by `time`.
uint8_t number_from(double time) {
	uint64_t bits = 0;
	std::memcpy(&bits, &time, sizeof(bits));
	return uint8_t((bits ^ bits >> 32) * 0x9e3779b97f4a7c15u >> 56);
}

} // namespace

bool Sender::add_body(uint32_t id, const cga::Pose<double> &pose, bool planar, std::optional<double> time) {
	if (_encoder) {
		return _encoder->add_body(id, ticks(time ? follow(*time) : _time), pose, planar);
	}
	IdleBody body;
	body.planar = planar;
	return id < ID_LIMIT && set_idle_pose(body, pose) && _idle_bodies.emplace(id, body).second;
}

bool Sender::set_idle_pose(IdleBody &body, const cga::Pose<double> &pose) const {
	const cga::Pose<double> used = body.planar ? BodyState::planar_part(pose) : pose;
	if (!BodyState::is_in_range(used, StreamGrid(float(_settings.position_tolerance), float(_settings.rotation_tolerance)))) {
		return false;
	}
	body.pose = used;
	return true;
}

bool Sender::observe(uint32_t id, double time, const cga::Pose<double> &pose) {
	if (!is_valid_time(time)) {
		return false;
	}
	_observed = follow(time);
	if (_encoder) {
		return _encoder->observe(id, ticks(_observed), pose);
	}
	const auto found = _idle_bodies.find(id);
	return found != _idle_bodies.end() && set_idle_pose(found->second, pose);
}

bool Sender::observe(uint32_t id, double time) {
	if (!is_valid_time(time)) {
		return false;
	}
	_observed = follow(time);
	return _encoder ? _encoder->observe(id, ticks(_observed)) : _idle_bodies.count(id) != 0;
}

void Sender::add_receiver(uint32_t receiver, double time, double now) {
	(void)follow(time);
	_now = _network_clock.advance(now);
	_peers.erase(receiver);
	_peers.emplace(receiver, Peer{ Delivery(_now) });
}

void Sender::remove_receiver(uint32_t receiver) {
	_peers.erase(receiver);
	if (_peers.empty()) {
		stop_encoder();
	}
}

double Sender::follow(double time) {
	if (!_clock.is_running()) {
		begin_at(_clock.advance(time, MAX_TIME));
	}
	// After a jump back, media time is that of the last flush.
	const double steady = _clock.at(time);
	return steady < _time - SteadyClock::MAX_STEP_BACK ? _time : steady;
}

void Sender::begin_at(double time) {
	_origin = _time = time;
	_window_begin = _last_flush = 0;
	_grid.reset();
}

void Sender::start_encoder(int64_t last_flush) {
	const double begin = std::max(ticks(std::min(_observed, _time)), double(last_flush));
	_window_begin = int64_t(std::ceil(begin - SAME_TICK));
	_encoder.emplace(float(_settings.position_tolerance), float(_settings.rotation_tolerance), _settings.mode);
	std::vector<uint32_t> ids;
	ids.reserve(_idle_bodies.size());
	for (const auto &body : _idle_bodies) {
		ids.push_back(body.first);
	}
	std::sort(ids.begin(), ids.end());
	for (const uint32_t id : ids) {
		const IdleBody &body = _idle_bodies[id];
		(void)_encoder->add_body(id, begin, body.pose, body.planar);
	}
	_idle_bodies.clear();
	for (auto &peer : _peers) {
		peer.second.delivery.restart(_now);
	}
	_changed_since = -1;
	_is_starting = true;
}

void Sender::stop_encoder() {
	if (_encoder) {
		_encoder->visit_bodies([this](uint32_t id, const cga::Pose<double> &pose, bool planar) { _idle_bodies.emplace(id, IdleBody{ pose, planar }); });
		_encoder.reset();
	}
}

double Sender::max_window() const {
	// The maximum time, over all receivers, from the end of a window to the arrival of its last chunk.
	double network = FRAME;
	for (const auto &peer : _peers) {
		const Delivery &delivery = peer.second.delivery;
		if (!delivery.is_silent(_now)) {
			const double once = std::max(3.0 * delivery.round_trip_deviation(), FRAME);
			network = std::max(network, once + (delivery.expected_loss() > NOTABLE_LOSS ? delivery.rto() + _settings.tick : 0.0));
		}
	}
	// While the chunks of a window are sent, the next window begins.
	const double spread = _ring.rate() / (_ring.rate() + Delivery::MAX_BURST / _settings.tick);
	const double longest = std::max((_settings.max_latency - network) / (1.0 + spread), _settings.max_latency * MIN_WINDOW);
	return std::clamp(std::min(1.0 / _settings.send_rate, _settings.max_latency), std::min(longest, MAX_WINDOW), MAX_WINDOW) / _settings.tick;
}

bool Sender::is_window_due(int64_t now) const {
	const double next = double(now) + _step;
	if (next - double(_window_begin) > double(MAX_TICKS) + SAME_TIME) {
		return true;
	}
	if (std::any_of(_peers.begin(), _peers.end(), [](const auto &peer) { return peer.second.delivery.needs_snapshot(); })) {
		return true;
	}
	if (_chunks_per_tick * (next - double(_window_begin)) > MAX_WINDOW_CHUNKS) {
		return true;
	}
	const double max_ticks = max_window();
	const bool is_aligned = _grid && _grid->ends_window(double(_window_begin), double(now), max_ticks);
	if (_changed_since >= 0) {
		return is_aligned || next - double(_changed_since) > max_ticks + SAME_TIME;
	}
	// The next aligned end would be too late.
	const double following = is_aligned ? double(now) + _grid->period : next;
	return following - double(_window_begin) > IDLE_WINDOW / _settings.tick;
}

uint32_t Sender::oldest_needed() const {
	uint32_t oldest = _ring.next();
	for (const auto &peer : _peers) {
		const Delivery &delivery = peer.second.delivery;
		oldest = delivery.is_silent(_now) || delivery.needs_snapshot() ? oldest : std::min(oldest, delivery.first_missing());
	}
	return oldest;
}

void Sender::close_window(int64_t end) {
	while (_window_begin < end) {
		const int length = int(std::min<int64_t>(end - _window_begin, MAX_TICKS));
		const uint32_t first_chunk = _ring.next();
		_window.clear();
		_encoder->encode_window(double(_window_begin), length, _window);
		_ring.push_window(_window, _encoder->check(), length * _settings.tick, _settings.max_packet_size, oldest_needed());
		_chunks_per_tick = double(_ring.next() - first_chunk) / length;
		_window_begin += length;
	}
	_changed_since = _encoder->has_changes() ? _window_begin : -1;
}

void Sender::start_snapshots() {
	std::shared_ptr<Snapshot> snapshot;
	for (auto &peer : _peers) {
		Delivery &delivery = peer.second.delivery;
		if (delivery.needs_snapshot() && !delivery.is_silent(_now)) {
			snapshot = snapshot != nullptr ? snapshot : make_snapshot();
			delivery.start_snapshot(snapshot);
		}
	}
}

std::shared_ptr<Snapshot> Sender::make_snapshot() {
	if (!_has_snapshot_number) {
		_has_snapshot_number = true;
		_snapshot_number = number_from(_origin);
	}
	auto snapshot = std::make_shared<Snapshot>();
	snapshot->number = ++_snapshot_number;
	snapshot->next_chunk = _ring.next();
	snapshot->fragment_size = Snapshot::fragment_size_for(_settings.max_packet_size);
	SnapshotHeader header;
	header.settings = _settings;
	header.tick = uint64_t(_window_begin);
	header.window = float(max_window() * _settings.tick);
	put_snapshot_header(snapshot->bytes, header);
	_encoder->encode_snapshot(snapshot->bytes);
	return snapshot;
}

void Sender::send_all() {
	// By default, receivers delay playback by up to twice max_latency from the begin of a window.
	const double max_wait = 2.0 * _settings.max_latency - max_window() * _settings.tick;
	for (auto &entry : _peers) {
		Peer &peer = entry.second;
		peer.delivery.set_max_wait(max_wait);
		peer.delivery.set_snapshot_size(Snapshot::estimate(body_count()));
		peer.delivery.send(_ring, _now, _settings.max_packet_size, _bytes, [&](size_t begin, size_t size) {
			_packets.push_back({ entry.first, begin, size });
			peer.bytes_sent += size;
			++peer.packets_sent;
		});
	}
}

void Sender::flush(double time, double now) {
	_bytes.clear();
	_packets.clear();
	(void)follow(time);
	_time = _clock.advance(time, MAX_TIME);
	_now = _network_clock.advance(now);
	int64_t tick = int64_t(std::floor(ticks(_time) + SAME_TICK));
	if (tick > LAST_TICK) {
		stop_encoder();
		_clock = SteadyClock();
		_observed = follow(time);
		tick = 0;
	}
	if (tick > _last_flush) {
		// A slowly decaying maximum of recent steps: a window must be closed before the next flush would make it too long.
		_step = std::clamp(double(tick - _last_flush), 0.9 * _step, MAX_STEP);
	}
	const int64_t before = _last_flush;
	_last_flush = tick;
	if (_peers.empty()) {
		_window_begin = tick;
		return;
	}
	if (_encoder && tick - _window_begin > MAX_PAUSE) {
		stop_encoder();
	}
	if (!_encoder) {
		start_encoder(tick - before > MAX_PAUSE ? tick : before);
	}
	if (_is_starting && tick >= _window_begin) {
		_encoder->start_at(double(_window_begin));
		start_snapshots();
		_is_starting = false;
	}
	if (_changed_since < 0 && _encoder->has_changes()) {
		// Close the idle window at once, so that the window with the motion can be short.
		close_window(std::max(_window_begin, std::min(before, tick - 1)));
		_changed_since = _window_begin;
	}
	if (tick > _window_begin && is_window_due(tick)) {
		close_window(tick);
		start_snapshots();
	}
	send_all();
}

PacketResult Sender::accept(uint32_t receiver, const uint8_t *packet, size_t size, double now) {
	const auto found = _peers.find(receiver);
	if (found == _peers.end()) {
		return PacketError::UNKNOWN_RECEIVER;
	}
	if (const PacketResult result = read_packet(packet, size, _content); !result) {
		return result;
	}
	const double steady = _network_clock.advance(now);
	found->second.delivery.accept(_content, _ring, steady);
	if (_content.alignment) {
		take_alignment(*_content.alignment, steady);
	}
	return {};
}

void Sender::take_alignment(const AlignItem &request, double now) {
	const double period = request.period / _settings.tick;
	// Far shorter windows, and frequent requests, would cost bytes.
	if ((_grid && request.number == _alignment) || now - _aligned_at < MIN_ALIGN_INTERVAL || period < 0.5 * max_window() || std::fabs(request.shift) > request.period) {
		return;
	}
	_alignment = request.number;
	_aligned_at = now;
	_grid = WindowGrid{ (_grid ? _grid->phase : double(_window_begin)) + request.shift / _settings.tick, period };
}

bool Sender::set_settings(const StreamSettings &settings) {
	if (!settings.is_valid()) {
		return false;
	}
	const bool restarts = !_settings.is_same_stream(settings);
	if (_settings.tick != settings.tick) {
		begin_at(_time);
	}
	_settings = settings;
	if (restarts) {
		stop_encoder();
	}
	return true;
}

void Sender::resend_all(uint32_t receiver) {
	const auto found = _peers.find(receiver);
	if (found != _peers.end()) {
		found->second.delivery.restart();
	}
}

ReceiverStatistics Sender::statistics(uint32_t receiver) const {
	const auto found = _peers.find(receiver);
	if (found == _peers.end()) {
		return {};
	}
	const Peer &peer = found->second;
	return { peer.bytes_sent, peer.packets_sent, peer.delivery.retransmissions(), peer.delivery.loss(), peer.delivery.round_trip() };
}

} // namespace net
