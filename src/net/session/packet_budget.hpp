#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace net {

/// Limits the packets of one peer, whatever they contain: a token bucket that time refills. A peer that empties it floods us. All its
/// packets are then ignored, which costs a look at their header, until it sends fewer than the rate for BURST seconds. Times in seconds.
class PacketBudget {
public:
	/// Packets per second of a peer without bodies, and for each of its bodies. 10,000 bodies that move take 300, acknowledgements one
	/// each frame.
	static constexpr double MIN_RATE = 2000.0;
	static constexpr double BODY_RATE = 1.0;
	/// Seconds of the rate that may arrive at once, after either side stood still.
	static constexpr double BURST = 0.5;
	/// A longer packet counts as one for each of so many bytes.
	static constexpr double BYTES = 1024.0;
	/// So much of the burst may be used before what has arrived waits to be decoded.
	static constexpr double PROMPT_SHARE = 1.0 / 8.0;

	enum class Verdict {
		ACCEPTED,
		FLOOD_BEGINS, ///< ignored, the first since packets were accepted
		IGNORED,
	};

	/// Counts a packet of `size` bytes from the owner of `bodies` bodies.
	Verdict take(size_t size, size_t bodies, double now) {
		refill(bodies, now);
		_left = std::max(_left - std::max(double(size) / BYTES, 1.0), -_capacity);
		if (_left > 0.0) {
			_is_flooded = false;
			return Verdict::ACCEPTED;
		}
		const bool was_flooded = std::exchange(_is_flooded, true);
		_left = was_flooded ? _left : -_capacity;
		return was_flooded ? Verdict::IGNORED : Verdict::FLOOD_BEGINS;
	}
	/// True if so many packets have arrived at once that they should not be decoded before it is known whether this is a flood.
	[[nodiscard]] bool is_busy(size_t bodies, double now) {
		refill(bodies, now);
		return _left < (1.0 - PROMPT_SHARE) * _capacity;
	}

private:
	void refill(size_t bodies, double now) {
		const double rate = MIN_RATE + BODY_RATE * double(bodies);
		const double used = _capacity - _left;
		_capacity = BURST * rate;
		_left = std::min(_capacity - used + std::max(now - _time, 0.0) * rate, _capacity);
		_time = now;
	}

	double _capacity = 0.0;
	double _left = 0.0;
	double _time = -1e9;
	bool _is_flooded = false;
};

} // namespace net
