#pragma once

#include <cmath>

namespace net {

/// Instants at which windows should end, in ticks.
struct WindowGrid {
	double phase = 0.0; ///< one of the instants
	double period = 0.0;

	/// True if a window from `begin` should end by `end`, and not before. If windows are limited to less than a period, the period is
	/// divided.
	[[nodiscard]] bool ends_window(double begin, double end, double max_window) const {
		const double interval = period / std::ceil(period / max_window - SAME);
		return instant(end, interval) > instant(begin, interval);
	}

private:
	static constexpr double SAME = 1e-4;

	[[nodiscard]] double instant(double tick, double interval) const { return std::floor((tick - phase) / interval + SAME); }
};

} // namespace net
