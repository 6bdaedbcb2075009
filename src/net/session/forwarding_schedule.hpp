#pragma once

#include "net/delivery/packet.hpp"

#include "net/motion/motion_code.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace net {

/// Measures when the windows of an owner arrive before the instants at which a relaying server forwards, and asks the owner to
/// shift them so that the server need not wait for them, nor they for it. Times in seconds.
class WindowAligner {
public:
	/// Records that a window arrived `lead` seconds before the next instant. `length` is that of the window.
	void add_arrival(double lead, double length, double now) {
		if (now >= _settled_at) {
			_leads[_count % COUNT] = lead;
			_lengths[_count++ % COUNT] = length;
		}
	}

	/// The request that is due: later windows should arrive a little later or earlier.
	[[nodiscard]] std::optional<AlignItem> take_request(double period, double tick, double now);
	[[nodiscard]] bool is_aligned() const { return _is_aligned; }
	/// Lead of the earliest recent arrivals.
	[[nodiscard]] double max_lead() const { return _max_lead; }

private:
	static constexpr size_t COUNT = 5; // windows
	std::array<double, COUNT> _leads{};
	std::array<double, COUNT> _lengths{};
	size_t _count = 0;
	double _max_lead = 0.0;
	double _spread = 0.0; // between recent leads
	double _interval = 0.0; // between the ends of windows
	double _settled_at = -1e9;
	uint8_t _number = 0;
	bool _is_aligned = false;
};

/// The ticks at which a relaying server forwards all streams at once.
class ForwardingSchedule {
public:
	/// Sets the current tick, and the time between two instants to at most `max_window`.
	void begin_tick(int64_t number, double time, double tick, double max_window) {
		_tick = tick;
		_ticks = std::clamp(int64_t(max_window / tick + 1e-6), int64_t(1), int64_t(MAX_TICKS));
		_left = _ticks - (number % _ticks + _ticks) % _ticks;
		_time = time;
	}

	/// Seconds between two instants.
	[[nodiscard]] double period() const { return double(_ticks) * _tick; }
	[[nodiscard]] double tick() const { return _tick; }
	/// Seconds from `now` to the next instant, from the current tick on.
	[[nodiscard]] double lead(double now) const { return std::max(_time + double(_left) * _tick - now, 0.0); }
	/// Ticks since the last instant; 0: the current tick is one.
	[[nodiscard]] int64_t ticks_since_instant() const { return _ticks - _left; }
	/// True if, at the current tick, windows that arrive up to `max_lead` seconds before the next instant should wait for it, which is
	/// at most MAX_HOLD ticks away.
	[[nodiscard]] bool holds(double max_lead, double now) const { return now - _time < 0.5 * _tick && _left <= std::clamp(int64_t(max_lead / _tick + 0.01), int64_t(1), MAX_HOLD) && 3 * _left <= _ticks; }

private:
	static constexpr int64_t MAX_HOLD = 2;

	double _tick = 1.0 / 60.0;
	int64_t _ticks = 1; // between two instants
	int64_t _left = 1; // ticks until the next instant
	double _time = 0.0; // of the current tick
};

} // namespace net
