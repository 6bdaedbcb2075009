#pragma once

#include <algorithm>
#include <limits>

namespace net {

/// A token bucket: real time refills it at `rate` per second, up to the amount of `burst` seconds. What is spent may exceed what is
/// left; nothing more should be done until time has made up for it.
class WorkBudget {
public:
	WorkBudget(double rate, double burst) :
			_rate(rate), _burst(burst), _left(rate * burst) {}

	void set_rate(double rate) { _rate = rate; }
	/// If `now` is before the last call, another clock begins.
	void refill(double now) {
		_left = std::min(_left + std::max(now - _time, 0.0) * _rate, _rate * _burst);
		_time = now;
	}
	void spend(double amount) { _left -= amount; }
	/// While held, the budget counts as spent.
	void hold(bool is_held) { _is_held = is_held; }
	[[nodiscard]] bool is_spent() const { return _is_held || _left <= 0.0; }
	/// Sets how much may be spent at once before a frame ends; by default, everything.
	void set_max_prompt(double amount) { _max_prompt = amount; }
	[[nodiscard]] double max_prompt() const { return _max_prompt; }
	/// True if more than `amount` has been spent beyond what was left.
	[[nodiscard]] bool is_overdrawn(double amount) const { return _left < -amount; }
	/// Forgets what was spent beyond what was left.
	void forgive() { _left = std::max(_left, 0.0); }

private:
	double _rate;
	double _burst;
	double _left;
	double _time = 0.0;
	double _max_prompt = std::numeric_limits<double>::infinity();
	bool _is_held = false;
};

} // namespace net
