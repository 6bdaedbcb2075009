#include "net/delivery/playback_clock.hpp"

#include <algorithm>

namespace net {

namespace {

/// Seconds in which playback makes good what it is off.
constexpr double SETTLING = 0.4;
/// Share of the speed by which it goes faster to catch up, slower to fall back.
constexpr double FASTER = 0.15;
constexpr double SLOWER = 0.4;
/// Farther behind than this playback jumps ahead, in seconds.
constexpr double JUMP = 0.75;

} // namespace

void RecentExtreme::add(double value, double now) {
	if (_empty) {
		_this = _before = value;
		_begin = now;
		_empty = false;
		return;
	}
	if (now - _begin > _span) {
		_before = _this;
		_this = value;
		_begin = now;
	}
	_this = _sign * std::max(_sign * _this, _sign * value);
}

double RecentExtreme::value() const {
	return _sign * std::max(_sign * _this, _sign * _before);
}

void PlaybackClock::start(double end, double delay, double now) {
	*this = PlaybackClock();
	_running = true;
	_position = end - delay;
	_last = now;
	observe(end, now);
	_need.add(delay, now);
}

void PlaybackClock::observe(double end, double now) {
	_offset.add(now - end, now);
	_lateness.add(now - end - _offset.value(), now);
}

double PlaybackClock::wanted_delay() const {
	return std::clamp(_need.value(), std::min(_least, _most), _most);
}

double PlaybackClock::rate(double now, double step) const {
	const double behind = now - _offset.value() - wanted_delay() - (_position + step);
	// In a long step no more than what it is off.
	return 1.0 + std::clamp(behind / std::max(SETTLING, step), -SLOWER, FASTER);
}

double PlaybackClock::media_time_at(double now) const {
	const double step = std::max(now - _last, 0.0);
	return _running ? _position + step * rate(now, step) : 0.0;
}

void PlaybackClock::advance(double now) {
	if (!_running) {
		return;
	}
	const double target = now - _offset.value() - wanted_delay();
	_position = target - media_time_at(now) > JUMP ? target : media_time_at(now);
	_last = std::max(now, _last);
}

double PlaybackClock::delay_at(double now) const {
	return _running ? now - _offset.value() - media_time_at(now) : 0.0;
}

double PlaybackClock::jitter() const {
	return _lateness.is_empty() ? 0.0 : _lateness.value();
}

} // namespace net
