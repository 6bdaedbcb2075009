#pragma once

#include "trace.hpp"

#include <limits>
#include <vector>

// How far what is shown is from what was, as docs/performance/network.md defines it.

namespace bench {

/// Of the points on a body's axes at which its error counts, in metres from its centre.
inline constexpr double LEVER_ARM = 0.25;
/// A body that is faster than this at its centre or at a lever point moves, in metres per second.
inline constexpr double MOVING_SPEED = 0.001;

/// The largest distance, in metres, between the places of a body's centre and of the points at LEVER on its three axes.
[[nodiscard]] double lever_distance(const cga::Pose<double> &a, const cga::Pose<double> &b);

enum class Motion : uint8_t {
	UNKNOWN, ///< the first sample of a body
	RESTING,
	MOVING,
};

/// For each sample of the body, whether it moved since the sample before it.
[[nodiscard]] std::vector<Motion> find_motion(const TraceBody &body);

/// The value below which `share` of the values are, between two of them in proportion; NaN if there is none. Sorts.
[[nodiscard]] double percentile(std::vector<double> &values, double share);

/// In metres; NaN where there was nothing to look at.
struct ErrorFigures {
	double p50 = std::numeric_limits<double>::quiet_NaN();
	double p99 = std::numeric_limits<double>::quiet_NaN();
	double max = std::numeric_limits<double>::quiet_NaN();
	double rest_p99 = std::numeric_limits<double>::quiet_NaN();
	double rest_max = std::numeric_limits<double>::quiet_NaN();
	size_t moving_count = 0;
	size_t resting_count = 0;
};

/// Errors of moving and of resting samples.
class ErrorSummary {
public:
	/// In metres; what is not a number counts as infinite. Samples of unknown motion do not count.
	void add(double error, Motion motion);
	/// Takes in what another one has.
	void add(const ErrorSummary &other);
	[[nodiscard]] ErrorFigures figures() const;

private:
	std::vector<double> _moving;
	std::vector<double> _resting;
};

} // namespace bench
