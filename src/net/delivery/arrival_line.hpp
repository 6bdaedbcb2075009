#pragma once

#include "net/delivery/recent_extreme.hpp"

namespace net {

/// Estimates when media time arrives: the line through (local time of an arrival, media time known then). Its slope is 1 for
/// a sender in real time, less for one that drops ticks. An alpha-beta filter follows the line (Kalata, "The Tracking Index",
/// 1984). A late arrival moves it only if the next one is late too: then the sender stood still, or it has slowed down, or the
/// route has changed. Times in seconds.
class ArrivalLine {
public:
	enum class Arrival {
		EXPECTED,
		SUSPECT, ///< far behind the line, which the next arrival will confirm or move
		MOVED, ///< the line has moved: this arrival is as late as the one before it
	};

	void start(double end, double now);
	/// Motion is known up to media time `end` at `now`; calls are in chronological order. With recent losses,
	/// an arrival has to be later to be suspect: retransmissions are late although the line has not moved.
	Arrival add(double end, double now, bool has_losses);

	/// The newest media time that can have arrived at `now`.
	[[nodiscard]] double newest_at(double now) const;
	/// Media seconds per local second.
	[[nodiscard]] double rate() const { return is_drifting() ? 1.0 - _drift : 1.0; }
	/// Spread between the earliest and the latest recent arrivals.
	[[nodiscard]] double jitter() const { return is_drifting() ? _latest.value() - _earliest.value() : _latest_offset.value() - _earliest_offset.value(); }

private:
	[[nodiscard]] bool is_drifting() const;
	void move_to(double end, double now);
	Arrival add_late(double end, double now, double bound);

	double _offset = 0.0; // local time minus media time at _time
	double _drift = 0.0; // change of the offset per second
	double _mean_drift = 0.0; // moving average
	double _time = 0.0;
	double _bias = 0.0; // moving average of the distance of an arrival from the line
	double _spread = 0.02; // moving average of the deviation from it
	bool _is_early = false; // the last arrival was far ahead of the line
	bool _is_late = false; // the last arrival was suspect
	double _late_offset = 0.0; // of that arrival
	double _late_time = 0.0;
	double _moved_at = -1e9; // when a late arrival last moved the line
	double _moved_offset = 0.0; // of that arrival
	RecentExtreme _earliest{ -1.0, 4.0 }; // distance from the line
	RecentExtreme _latest{ 1.0, 2.0 };
	RecentExtreme _earliest_offset{ -1.0, 4.0 }; // since the drift ended
	RecentExtreme _latest_offset{ 1.0, 2.0 };
};

} // namespace net
