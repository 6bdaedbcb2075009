#pragma once

#include <algorithm>

namespace net {

/// Times at which a request is repeated: the pause between two of them doubles, from FIRST to a maximum. Times in seconds.
class Repetition {
public:
	static constexpr double FIRST = 0.25;

	explicit Repetition(double max_pause) :
			_max_pause(max_pause) {}

	/// Makes the request due at `time`, with the shortest pause after it.
	void restart(double time) {
		_due = time;
		_pause = FIRST;
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
};

} // namespace net
