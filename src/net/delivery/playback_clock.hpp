#pragma once

namespace net {

/// The maximum or minimum of recent values, over the current time span and the previous one.
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
	/// Starts at `now`. Motion is known up to media time `end`; playback starts at `end - delay`.
	void start(double end, double delay, double now);
	/// Records that a window ending at media time `end` arrived at `now`.
	void observe(double end, double now);
	/// Records that motion beginning at media time `begin` arrived at `now`. Playback should not have reached `begin` yet.
	void observe_motion(double begin, double now) { _required_delay.add(now - begin - _offset.value(), now); }
	/// Advances playback to `now`.
	void advance(double now);

	[[nodiscard]] bool is_running() const { return _running; }
	[[nodiscard]] double media_time() const { return _position; }
	[[nodiscard]] double media_time_at(double now) const;
	/// The target delay behind the newest media time that can have arrived.
	[[nodiscard]] double target_delay() const;
	/// The actual delay at `now`.
	[[nodiscard]] double delay_at(double now) const;
	/// Spread between the earliest and the latest recent arrivals, in seconds.
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
	RecentExtreme _offset{ -1.0, 4.0 }; // local time minus media time, at arrival
	RecentExtreme _required_delay{ 1.0, 6.0 }; // from the begin of a motion to its arrival, in local time
	RecentExtreme _lateness{ 1.0, 2.0 };
};

} // namespace net
