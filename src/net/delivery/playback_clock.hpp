#pragma once

namespace net {

/// The largest, or smallest, of recent values: of this span of time and the one before it.
class RecentExtreme {
public:
	/// `sign` 1 for the largest, -1 for the smallest; `span` in seconds.
	RecentExtreme(double sign, double span) :
			sign_(sign), span_(span) {}

	void add(double value, double now);
	[[nodiscard]] double value() const;
	[[nodiscard]] bool is_empty() const { return empty_; }

private:
	double sign_;
	double span_;
	double this_ = 0.0;
	double before_ = 0.0;
	double begin_ = 0.0;
	bool empty_ = true;
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
	void observe_motion(double begin, double now) { need_.add(now - begin - offset_.value(), now); }
	/// Moves playback on to `now`.
	void advance(double now);

	[[nodiscard]] bool is_running() const { return running_; }
	[[nodiscard]] double media_time() const { return position_; }
	[[nodiscard]] double media_time_at(double now) const;
	/// The delay that playback aims at, behind the newest media time that could have arrived.
	[[nodiscard]] double wanted_delay() const;
	/// The delay that playback has at `now`.
	[[nodiscard]] double delay_at(double now) const;
	/// How much later than the earliest the latest of the recent arrivals was.
	[[nodiscard]] double jitter() const;

	/// Between these the delay adapts.
	void set_limits(double least, double most) {
		least_ = least;
		most_ = most;
	}

private:
	[[nodiscard]] double rate(double now, double step) const;

	bool running_ = false;
	double position_ = 0.0;
	double last_ = 0.0;
	double least_ = 0.0;
	double most_ = 0.2;
	RecentExtreme offset_{ -1.0, 4.0 }; // of local minus media time at arrival
	RecentExtreme need_{ 1.0, 6.0 }; // from the begin of what arrived to its arrival, in local time
	RecentExtreme lateness_{ 1.0, 2.0 };
};

} // namespace net
