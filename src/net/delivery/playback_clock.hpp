#pragma once

namespace net {

/// The maximum or minimum of recent values: those of the current span of time and the one before.
class RecentExtreme {
public:
	/// `sign` 1 for the maximum, -1 for the minimum; `span` in seconds.
	RecentExtreme(double sign, double span) :
			_sign(sign), _span(span) {}

	void add(double value, double now);
	[[nodiscard]] double value() const;
	[[nodiscard]] bool is_empty() const { return _empty; }

private:
	double _sign;
	double _span;
	double _current = 0.0;
	double _previous = 0.0;
	double _begin = 0.0;
	bool _empty = true;
};

/// Maps a receiver's local time to the media time it shows. The earliest recent arrivals estimate the sender's clock; the
/// lateness of recent arrivals sets the playback delay. Playback follows by running a little faster or slower, never
/// backwards. Times in seconds.
class PlaybackClock {
public:
	/// Starts at `now`, with motion known up to media time `end`, `delay` behind it.
	void start(double end, double delay, double now);
	/// A window arrived at `now` that ends at media time `end`.
	void observe(double end, double now);
	/// The window's motion begins at `begin`, which playback should not have reached yet.
	void observe_motion(double begin, double now) { _required_delay.add(now - begin - _offset.value(), now); }
	/// Advances playback to `now`.
	void advance(double now);

	[[nodiscard]] bool is_running() const { return _running; }
	[[nodiscard]] double media_time() const { return _position; }
	[[nodiscard]] double media_time_at(double now) const;
	/// The delay playback aims at, behind the newest media time that can have arrived.
	[[nodiscard]] double target_delay() const;
	/// The delay that playback has at `now`.
	[[nodiscard]] double delay_at(double now) const;
	/// Spread between the earliest and the latest of the recent arrivals.
	[[nodiscard]] double jitter() const;

	/// Limits of the delay.
	void set_limits(double min_delay, double max_delay) {
		_min_delay = min_delay;
		_max_delay = max_delay;
	}

private:
	[[nodiscard]] double rate(double now, double step) const;

	bool _running = false;
	double _position = 0.0;
	double _last = 0.0;
	double _min_delay = 0.0;
	double _max_delay = 0.2;
	RecentExtreme _offset{ -1.0, 4.0 }; // local minus media time at arrival
	RecentExtreme _required_delay{ 1.0, 6.0 }; // from the beginning of motion to its arrival, in local time
	RecentExtreme _lateness{ 1.0, 2.0 };
};

} // namespace net
