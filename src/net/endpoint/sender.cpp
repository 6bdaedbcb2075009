#include "net/endpoint/sender.hpp"

#include "net/stream/snapshot_header.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace net {

namespace {

/// Upper bound of the estimated step between two flushes, in ticks. Longer steps are pauses.
constexpr double MAX_STEP = 4.0;
/// A time this short of a tick counts as that tick: recorded times are rounded.
constexpr double SAME_TICK = 0.01;

/// After a pause of more than this, in ticks, the stream goes on with a snapshot, as the windows of the pause would take too long.
constexpr int64_t MAX_PAUSE = int64_t(64) * MAX_TICKS;
/// Beyond this tick, the stream starts anew: a double holds ticks and fractions of 1/4096 up to it.
constexpr int64_t LAST_TICK = int64_t(1) << 40;
/// Receivers are moved between streams at most this often, in seconds, and once their line has differed for MIN_DIFFERENCE_TIME; back to
/// the better stream, which takes a snapshot, after MIN_GOOD_TIME.
constexpr double BALANCE_INTERVAL = 0.25;
constexpr double MIN_DIFFERENCE_TIME = 1.0;
constexpr double MIN_GOOD_TIME = 10.0;
/// After joining, a receiver is not moved for this many seconds: nothing is known of its line.
constexpr double SETTLING_TIME = 3.0;
/// A line is worse than others if it needs this many seconds more, or cannot carry the stream; it is as good as they are within
/// half of that.
constexpr double WORSE_BY = 0.025;
/// A line must carry this many times the stream that it is to get.
constexpr double SPARE_RATE = 1.3;
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
	if (is_running()) {
		const double at = ticks(time ? follow(*time) : _time);
		return for_each_encoder([&](StreamEncoder &encoder) { return encoder.add_body(id, at, pose, planar); });
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
	if (is_running()) {
		return for_each_encoder([&](StreamEncoder &encoder) { return encoder.observe(id, ticks(_observed), pose); });
	}
	const auto found = _idle_bodies.find(id);
	return found != _idle_bodies.end() && set_idle_pose(found->second, pose);
}

bool Sender::observe(uint32_t id, double time) {
	if (!is_valid_time(time)) {
		return false;
	}
	_observed = follow(time);
	return is_running() ? for_each_encoder([&](StreamEncoder &encoder) { return encoder.observe(id, ticks(_observed)); }) : _idle_bodies.count(id) != 0;
}

bool Sender::set_priority(uint32_t id, int priority) {
	if (is_running()) {
		return for_each_encoder([&](StreamEncoder &encoder) { return encoder.set_priority(id, priority); });
	}
	const auto found = _idle_bodies.find(id);
	if (found == _idle_bodies.end()) {
		return false;
	}
	found->second.priority = priority;
	return true;
}

void Sender::add_receiver(uint32_t receiver, double time, double now) {
	(void)follow(time);
	_now = _network_clock.advance(now);
	for (const auto &stream : _streams) {
		stream->peers().erase(receiver);
	}
	OutgoingStream::Peer peer{ Delivery(_now) };
	peer.joined_at = _now;
	main().peers().emplace(receiver, std::move(peer));
}

void Sender::remove_receiver(uint32_t receiver) {
	for (const auto &stream : _streams) {
		stream->peers().erase(receiver);
	}
	merge();
	if (main().peers().empty()) {
		stop_encoder();
	}
}

OutgoingStream *Sender::stream_of(uint32_t receiver) const {
	for (const auto &stream : _streams) {
		if (stream->peers().count(receiver) != 0) {
			return stream.get();
		}
	}
	return nullptr;
}

void Sender::move(uint32_t receiver, OutgoingStream &from, OutgoingStream &to) {
	const auto found = from.peers().find(receiver);
	found->second.joined_at = _now;
	found->second.differs_since = -1.0;
	to.peers().emplace(receiver, std::move(found->second));
	from.peers().erase(found);
}

void Sender::merge() {
	if (_streams.size() > 1 && (_streams[1]->peers().empty() || main().peers().empty())) {
		_streams.erase(_streams.begin() + (main().peers().empty() ? 0 : 1));
	}
}

void Sender::balance() {
	if (_now - _balanced_at < BALANCE_INTERVAL) {
		return;
	}
	_balanced_at = _now;
	const auto differs_for = [this](OutgoingStream::Peer &peer, bool differs) {
		peer.differs_since = !differs ? -1.0 : (peer.differs_since < 0.0 ? _now : peer.differs_since);
		return differs ? _now - peer.differs_since : 0.0;
	};
	// The lines of most receivers of the main stream are no worse than this.
	std::vector<double> times;
	for (const auto &entry : main().peers()) {
		times.push_back(main().network_time(entry.second, _now));
	}
	std::sort(times.begin(), times.end());
	const double usual = times[(times.size() - 1) / 2];
	std::vector<uint32_t> worse;
	for (auto &[id, peer] : main().peers()) {
		const bool is_worse = main().network_time(peer, _now) > usual + WORSE_BY || main().waiting_time(peer) > _settings.tick;
		const bool is_settled = _now - peer.joined_at > SETTLING_TIME && !peer.delivery.is_silent(_now);
		if (differs_for(peer, is_worse && is_settled) >= MIN_DIFFERENCE_TIME) {
			worse.push_back(id);
		}
	}
	if (!worse.empty() && worse.size() < main().peers().size()) {
		const bool is_new = _streams.size() == 1;
		if (is_new) {
			_streams.push_back(std::make_unique<OutgoingStream>(main()));
			_streams[1]->peers().clear();
		}
		for (const uint32_t id : worse) {
			move(id, main(), *_streams[1]);
			if (!is_new) {
				_streams[1]->peers().at(id).delivery.restart();
			}
		}
	}
	if (_streams.size() == 1) {
		return;
	}
	std::vector<uint32_t> better;
	for (auto &[id, peer] : _streams[1]->peers()) {
		const CongestionControl &line = peer.delivery.congestion();
		const bool carries = !line.is_limiting() || line.rate() > SPARE_RATE * main().rate();
		if (differs_for(peer, carries && _streams[1]->network_time(peer, _now) < usual + 0.5 * WORSE_BY) >= MIN_GOOD_TIME) {
			better.push_back(id);
		}
	}
	for (const uint32_t id : better) {
		move(id, *_streams[1], main());
		main().peers().at(id).delivery.restart();
	}
	merge();
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
	_last_flush = 0;
	main().set_window_begin(0);
	_grid.reset();
}

void Sender::start_encoder(int64_t last_flush) {
	const double begin = std::max(ticks(std::min(_observed, _time)), double(last_flush));
	main().start(begin - SAME_TICK, _now);
	std::vector<uint32_t> ids;
	ids.reserve(_idle_bodies.size());
	for (const auto &body : _idle_bodies) {
		ids.push_back(body.first);
	}
	std::sort(ids.begin(), ids.end());
	for (const uint32_t id : ids) {
		const IdleBody &body = _idle_bodies[id];
		(void)main().encoder().add_body(id, begin, body.pose, body.planar);
		(void)main().encoder().set_priority(id, body.priority);
	}
	_idle_bodies.clear();
}

void Sender::stop_encoder() {
	if (is_running()) {
		main().encoder().visit_bodies([this](uint32_t id, const cga::Pose<double> &pose, bool planar, int priority) { _idle_bodies.emplace(id, IdleBody{ pose, planar, priority }); });
		main().stop();
		if (_streams.size() > 1) {
			main().peers().merge(_streams[1]->peers());
			_streams.pop_back();
		}
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
	if (main().peers().empty()) {
		main().set_window_begin(tick);
		return;
	}
	if (is_running() && tick - main().window_begin() > MAX_PAUSE) {
		stop_encoder();
	}
	if (!is_running()) {
		start_encoder(tick - before > MAX_PAUSE ? tick : before);
	}
	if (!_has_snapshot_number) {
		_has_snapshot_number = true;
		_snapshot_number = number_from(_origin);
	}
	balance();
	for (const auto &stream : _streams) {
		stream->flush({ tick, before, _step, _now, _grid, _snapshot_number });
		stream->send(_now, _bytes, _packets);
	}
}

PacketResult Sender::accept(uint32_t receiver, const uint8_t *packet, size_t size, double now, bool can_align) {
	OutgoingStream *stream = stream_of(receiver);
	if (stream == nullptr) {
		return PacketError::UNKNOWN_RECEIVER;
	}
	if (const PacketResult result = read_packet(packet, size, _content); !result) {
		return result;
	}
	const double steady = _network_clock.advance(now);
	stream->accept(stream->peers().at(receiver), _content, steady);
	if (_content.alignment && can_align) {
		take_alignment(*_content.alignment, steady);
	}
	return {};
}

void Sender::take_alignment(const AlignItem &request, double now) {
	const double period = request.period / _settings.tick;
	// Far shorter windows, and frequent requests, would cost bytes.
	if ((_grid && request.number == _alignment) || now - _aligned_at < MIN_ALIGN_INTERVAL || period < 0.5 * main().max_window(_now) || std::fabs(request.shift) > request.period) {
		return;
	}
	_alignment = request.number;
	_aligned_at = now;
	_grid = WindowGrid{ (_grid ? _grid->phase : double(main().window_begin())) + request.shift / _settings.tick, period };
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
	for (const auto &stream : _streams) {
		stream->set_settings(settings);
	}
	return true;
}

void Sender::resend_all(uint32_t receiver) {
	if (OutgoingStream *stream = stream_of(receiver)) {
		stream->peers().at(receiver).delivery.restart();
	}
}

ReceiverStatistics Sender::statistics(uint32_t receiver) const {
	const OutgoingStream *stream = stream_of(receiver);
	if (stream == nullptr) {
		return {};
	}
	const OutgoingStream::Peer &peer = stream->peers().at(receiver);
	const CongestionControl &line = peer.delivery.congestion();
	const bool is_limited = line.is_validated() && line.is_limiting();
	return { peer.bytes_sent, peer.packets_sent, peer.delivery.retransmissions(), peer.delivery.loss(), peer.delivery.round_trip(), is_limited ? line.rate() : 0.0, stream->relaxation() };
}

} // namespace net
