#pragma once

#include <algorithm>

namespace net {

/// Times at which a request is repeated: the pause between two of them doubles, from FIRST to a maximum. Times in seconds.
class Repetition {
public:
	static constexpr double FIRST = 0.25;
	static constexpr double HASTE_BURST = 4.0;
	static constexpr double HASTE_INTERVAL = 2.0;

	explicit Repetition(double max_pause) :
			_max_pause(max_pause) {}

	/// Makes the request due at `time`, with the shortest pause after it.
	void restart(double time) {
		_due = time;
		_pause = FIRST;
	}
	/// Makes the request due at once, because a peer has caused it: HASTE_BURST times in a row, then every HASTE_INTERVAL.
	void hasten(double now) {
		if (now >= _hasty) {
			_next_hasty = std::max(_next_hasty, now - (HASTE_BURST - 1.0) * HASTE_INTERVAL);
			_hasty = std::max(now, _next_hasty);
			_next_hasty += HASTE_INTERVAL;
		}
		restart(_hasty);
	}
	/// Makes the request due after the next pause.
	void back_off(double now) {
		_due = now + _pause;
		_pause = std::min(2.0 * _pause, _max_pause);
	}
	[[nodiscard]] bool is_due(double now) const { return now >= _due; }

private:
	double _max_pause;
	double _pause = FIRST;
	double _due = 0.0;
	double _hasty = -1e9; // time of the last request that a peer has caused, and the earliest of the next one
	double _next_hasty = -1e9;
};

} // namespace net
