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
	if (empty_) {
		this_ = before_ = value;
		begin_ = now;
		empty_ = false;
		return;
	}
	if (now - begin_ > span_) {
		before_ = this_;
		this_ = value;
		begin_ = now;
	}
	this_ = sign_ * std::max(sign_ * this_, sign_ * value);
}

double RecentExtreme::value() const {
	return sign_ * std::max(sign_ * this_, sign_ * before_);
}

void PlaybackClock::start(double end, double delay, double now) {
	*this = PlaybackClock();
	running_ = true;
	position_ = end - delay;
	last_ = now;
	observe(end, now);
	need_.add(delay, now);
}

void PlaybackClock::observe(double end, double now) {
	offset_.add(now - end, now);
	lateness_.add(now - end - offset_.value(), now);
}

double PlaybackClock::wanted_delay() const {
	return std::clamp(need_.value(), std::min(least_, most_), most_);
}

double PlaybackClock::rate(double now, double step) const {
	const double behind = now - offset_.value() - wanted_delay() - (position_ + step);
	// In a long step no more than what it is off.
	return 1.0 + std::clamp(behind / std::max(SETTLING, step), -SLOWER, FASTER);
}

double PlaybackClock::media_time_at(double now) const {
	const double step = std::max(now - last_, 0.0);
	return running_ ? position_ + step * rate(now, step) : 0.0;
}

void PlaybackClock::advance(double now) {
	if (!running_) {
		return;
	}
	const double target = now - offset_.value() - wanted_delay();
	position_ = target - media_time_at(now) > JUMP ? target : media_time_at(now);
	last_ = std::max(now, last_);
}

double PlaybackClock::delay_at(double now) const {
	return running_ ? now - offset_.value() - media_time_at(now) : 0.0;
}

double PlaybackClock::jitter() const {
	return lateness_.is_empty() ? 0.0 : lateness_.value();
}

} // namespace net
