#pragma once

namespace net {

/// The largest, or smallest, of recent values: of this span of time and the one before it.
class RecentExtreme {
public:
	/// `sign` 1 for the largest, -1 for the smallest; `span` in seconds.
	RecentExtreme(double sign, double span) :
			_sign(sign), _span(span) {}

	void add(double value, double now);
	[[nodiscard]] double value() const;
	[[nodiscard]] bool is_empty() const { return _empty; }

private:
	double _sign;
	double _span;
	double _this = 0.0;
	double _before = 0.0;
	double _begin = 0.0;
	bool _empty = true;
};

/// Which media time a receiver shows. The sender's clock is seen through the earliest of the recent arrivals, the delay
/// is what the recent arrivals needed; playback follows by running a little faster or slower, never backwards.
/// Seconds throughout.
class PlaybackClock {
public:
	/// Begins at `now` with what is known up to media time `end`, `delay` behind it.
	void start(double end, double delay, double now);
	/// Something arrived at `now` that says what happened up to media time `end`.
	void observe(double end, double now);
	/// It tells of motion from `begin` on, so that playback must not have passed `begin` by then.
	void observe_motion(double begin, double now) { _need.add(now - begin - _offset.value(), now); }
	/// Moves playback on to `now`.
	void advance(double now);

	[[nodiscard]] bool is_running() const { return _running; }
	[[nodiscard]] double media_time() const { return _position; }
	[[nodiscard]] double media_time_at(double now) const;
	/// The delay that playback aims at, behind the newest media time that could have arrived.
	[[nodiscard]] double wanted_delay() const;
	/// The delay that playback has at `now`.
	[[nodiscard]] double delay_at(double now) const;
	/// How much later than the earliest the latest of the recent arrivals was.
	[[nodiscard]] double jitter() const;

	/// Between these the delay adapts.
	void set_limits(double least, double most) {
		_least = least;
		_most = most;
	}

private:
	[[nodiscard]] double rate(double now, double step) const;

	bool _running = false;
	double _position = 0.0;
	double _last = 0.0;
	double _least = 0.0;
	double _most = 0.2;
	RecentExtreme _offset{ -1.0, 4.0 }; // of local minus media time at arrival
	RecentExtreme _need{ 1.0, 6.0 }; // from the begin of what arrived to its arrival, in local time
	RecentExtreme _lateness{ 1.0, 2.0 };
};

} // namespace net
