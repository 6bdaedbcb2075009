#include "net/delivery/playback_clock.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// Time constant with which playback approaches its target, in seconds.
constexpr double TIME_CONSTANT = 0.4;
/// Maximum relative change of the playback rate, to catch up and to fall back.
constexpr double MAX_SPEEDUP = 0.15;
constexpr double MAX_SLOWDOWN = 0.4;
/// If playback is farther behind its target than this, in seconds, it jumps to the target.
constexpr double MAX_BEHIND = 0.75;
/// While motion arrives, playback runs at most this many seconds past the known motion: if nothing moves, windows last 0.5 s.
constexpr double MAX_UNKNOWN = 0.6;
/// Arrivals closer together than this, in seconds, are one.
constexpr double SAME_INSTANT = 0.001;
/// Silence is unusual beyond this many mean intervals between packets, and this many seconds more.
constexpr double SILENT_INTERVALS = 1.5;
constexpr double SILENT_TIME = 0.06;
constexpr double INTERVAL_WEIGHT = 1.0 / 16.0;
constexpr double MAX_INTERVAL = 0.5;
/// Seconds for which a loss makes late arrivals likely: at a low loss, and more for each unit of loss.
constexpr double LOSS_MEMORY = 0.25;
constexpr double LOSS_MEMORY_SLOPE = 5.0;
/// The delay is adapted to silences only if they are less than this many seconds apart.
constexpr double RARE_SILENCE = 6.0;
/// A change of the sender's rate after which the required delay is measured again.
constexpr double NEW_RATE = 0.03;
/// If playback has not advanced for this many seconds, this peer stood still, not the network.
constexpr double LOCAL_STALL = 0.1;
/// Seconds in which everything arrives that was held up during a silence.
constexpr double BACKLOG_TIME = 0.1;

} // namespace

void PlaybackClock::start(double end, double delay, double now) {
	const double min_delay = _min_delay;
	const double max_delay = _max_delay;
	*this = PlaybackClock();
	set_limits(min_delay, max_delay);
	_running = true;
	_begin = end;
	_position = end - delay;
	_last = _packet_time = _known_at = now;
	_known = end;
	_line.start(end, now);
	_required_delay.add(delay, now);
}

void PlaybackClock::observe_packet(double now) {
	const double interval = now - _packet_time;
	if (interval < SAME_INSTANT) {
		return;
	}
	const bool is_silent = interval > SILENT_INTERVALS * _packet_interval + SILENT_TIME;
	if (is_silent) {
		_is_silence_rare = now - _silence_end > RARE_SILENCE;
		_silence_end = now;
	}
	_packet_interval += (std::min(interval, MAX_INTERVAL) - _packet_interval) * INTERVAL_WEIGHT;
	_packet_time = now;
}

void PlaybackClock::observe_loss(double loss, double now) {
	_losses_until = now + LOSS_MEMORY + LOSS_MEMORY_SLOPE * loss;
}

void PlaybackClock::observe(double begin, double end, double now) {
	if (_batch.is_open && now - _batch.time < SAME_INSTANT) {
		_batch.begin = std::min(begin, _batch.begin);
		_batch.end = end;
		return;
	}
	close_batch();
	const bool is_backlog = _is_silence_rare && now - _silence_end < BACKLOG_TIME;
	_batch = { now, begin, end, is_backlog || now - _last > LOCAL_STALL, true };
}

void PlaybackClock::close_batch() {
	if (!_batch.is_open) {
		return;
	}
	_batch.is_open = false;
	_known = _batch.end;
	_known_at = _batch.time;
	const ArrivalLine::Arrival arrival = _line.add(_batch.end, _batch.time, _batch.time < _losses_until);
	if (arrival == ArrivalLine::Arrival::MOVED) {
		// The delay was the sender's, not the network's.
		_suspect_delay = 0.0;
		_required_delay.clear();
		if (_position > _batch.begin) {
			_position = _batch.begin;
			_last = std::max(_last, _batch.time);
		}
	}
	if (std::fabs(_line.rate() - _delay_rate) > NEW_RATE && _batch.time >= _losses_until) {
		// What was required of a sender of another rate says little.
		_delay_rate = _line.rate();
		_required_delay.clear();
	}
	if (_suspect_delay > 0.0) {
		_required_delay.add(_suspect_delay, _batch.time);
		_suspect_delay = 0.0;
	}
	if (_batch.begin == _batch.end || _batch.is_after_silence) {
		return;
	}
	const double delay = _line.newest_at(_batch.time) - _batch.begin;
	if (arrival == ArrivalLine::Arrival::SUSPECT) {
		_suspect_delay = delay;
	} else {
		_required_delay.add(delay, _batch.time);
	}
}

double PlaybackClock::target_delay() const {
	return std::clamp(_required_delay.value(), std::min(_min_delay, _max_delay), _max_delay);
}

double PlaybackClock::speed(double now, double step) const {
	const double rate = _line.rate();
	const double behind = target(now) - (_position + step * rate);
	// A step longer than the time constant must not overshoot the target.
	return rate + std::clamp(behind / std::max(TIME_CONSTANT, step), -MAX_SLOWDOWN * rate, MAX_SPEEDUP - std::clamp(rate - 1.0, 0.0, 0.5 * MAX_SPEEDUP));
}

double PlaybackClock::position_at(double now) const {
	const double step = std::max(now - _last, 0.0);
	return _running ? _position + step * speed(now, step) : 0.0;
}

void PlaybackClock::advance(double now) {
	if (!_running) {
		return;
	}
	close_batch();
	const double next = target(now) - position_at(now) > MAX_BEHIND ? target(now) : position_at(now);
	// While a backlog arrives, and for a while after it, the line is too steep: playback then stays within the known motion.
	const double max_unknown = _line.rate() > 1.0 + NEW_RATE ? 0.0 : MAX_UNKNOWN;
	const double last = now - _known_at < MAX_INTERVAL + SILENT_TIME ? std::max(_known + max_unknown, _position) : next;
	_position = std::min(next, last);
	_last = std::max(now, _last);
}

double PlaybackClock::delay_at(double now) const {
	if (!_running) {
		return 0.0;
	}
	const bool is_silent = now - _known_at > MAX_INTERVAL + SILENT_TIME;
	const double shown = is_silent ? std::min(_known, media_time_at(now)) : media_time_at(now);
	return (_line.newest_at(now) - shown) / _line.rate();
}

} // namespace net
