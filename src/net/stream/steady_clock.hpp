#pragma once

#include <algorithm>
#include <cmath>

namespace net {

/// Bound of the times that callers pass, in seconds: above it, a double cannot tell neighboring ticks apart.
inline constexpr double MAX_TIME = 1e12;

[[nodiscard]] inline bool is_valid_time(double time) {
	return std::fabs(time) <= MAX_TIME; // false for NaN
}

/// Converts the times of a caller's clock, which may jump, into a time that never decreases. Both are equal until the clock first jumps,
/// or is negative. Times in seconds.
class SteadyClock {
public:
	/// By default, a longer step of the clock counts as one of this length: it exceeds all timeouts.
	static constexpr double MAX_STEP = 60.0;
	/// After a step back of at most this, the steady time waits for the clock. After a longer one, it continues from where it is.
	static constexpr double MAX_STEP_BACK = 1.0;

	/// Returns the steady time at the clock's time `now`. An invalid time leaves it as it was.
	double advance(double now, double max_step = MAX_STEP) {
		if (!is_valid_time(now)) {
			return _time;
		}
		if (!_is_running) {
			_is_running = true;
			_offset = std::max(-now, 0.0);
			_time = now + _offset;
		}
		const double step = now + _offset - _time;
		if (step > max_step || step < -MAX_STEP_BACK) {
			_offset = _time + std::clamp(step, 0.0, max_step) - now;
		}
		_time = std::max(_time, now + _offset);
		return _time;
	}
	/// Converts a time of the clock, which is taken not to have jumped since the last `advance`.
	[[nodiscard]] double at(double now) const { return is_valid_time(now) ? now + _offset : _time; }
	[[nodiscard]] bool is_running() const { return _is_running; }

private:
	bool _is_running = false;
	double _time = 0.0;
	double _offset = 0.0; // from the clock to the steady time
};

} // namespace net
