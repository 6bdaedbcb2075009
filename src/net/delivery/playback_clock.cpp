#include "net/delivery/playback_clock.hpp"

#include <algorithm>

namespace net {

namespace {

/// Time constant with which playback approaches its target, in seconds.
constexpr double TIME_CONSTANT = 0.4;
/// Maximum relative change of the playback rate, to catch up and to fall back.
constexpr double MAX_SPEEDUP = 0.15;
constexpr double MAX_SLOWDOWN = 0.4;
/// If playback is farther behind its target than this, in seconds, it jumps to the target.
constexpr double MAX_BEHIND = 0.75;

} // namespace

void RecentExtreme::add(double value, double now) {
	if (_empty) {
		_current = _previous = value;
		_begin = now;
		_empty = false;
		return;
	}
	if (now - _begin > _span) {
		_previous = _current;
		_current = value;
		_begin = now;
	}
	_current = _sign * std::max(_sign * _current, _sign * value);
}

double RecentExtreme::value() const {
	return _sign * std::max(_sign * _current, _sign * _previous);
}

void PlaybackClock::start(double end, double delay, double now) {
	*this = PlaybackClock();
	_running = true;
	_position = end - delay;
	_last = now;
	observe(end, now);
	_required_delay.add(delay, now);
}

void PlaybackClock::observe(double end, double now) {
	_offset.add(now - end, now);
	_lateness.add(now - end - _offset.value(), now);
}

double PlaybackClock::target_delay() const {
	return std::clamp(_required_delay.value(), std::min(_min_delay, _max_delay), _max_delay);
}

double PlaybackClock::rate(double now, double step) const {
	const double behind = now - _offset.value() - target_delay() - (_position + step);
	// A step longer than the time constant must not overshoot the target.
	return 1.0 + std::clamp(behind / std::max(TIME_CONSTANT, step), -MAX_SLOWDOWN, MAX_SPEEDUP);
}

double PlaybackClock::media_time_at(double now) const {
	const double step = std::max(now - _last, 0.0);
	return _running ? _position + step * rate(now, step) : 0.0;
}

void PlaybackClock::advance(double now) {
	if (!_running) {
		return;
	}
	const double target = now - _offset.value() - target_delay();
	_position = target - media_time_at(now) > MAX_BEHIND ? target : media_time_at(now);
	_last = std::max(now, _last);
}

double PlaybackClock::delay_at(double now) const {
	return _running ? now - _offset.value() - media_time_at(now) : 0.0;
}

double PlaybackClock::jitter() const {
	return _lateness.is_empty() ? 0.0 : _lateness.value();
}

} // namespace net
