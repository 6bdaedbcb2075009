#pragma once

#include "trace.hpp"

#include <limits>
#include <vector>

// The error of shown poses, as docs/performance/network.md defines it.

namespace bench {

/// Distance of the points at the lever arm, at which rotation error is measured, from the body's center along its axes, in meters.
inline constexpr double LEVER_ARM = 0.25;
/// A body moves if its center or a point at the lever arm is faster than this, in meters per second.
inline constexpr double MOVING_SPEED = 0.001;

/// The largest distance, in meters, between two poses of a body: of its center and its three points at the lever arm.
[[nodiscard]] double lever_distance(const cga::Pose<double> &a, const cga::Pose<double> &b);

enum class Motion : uint8_t {
	UNKNOWN, ///< the first sample of a body
	RESTING,
	MOVING,
};

/// For each sample of the body, whether it moved since the previous one.
[[nodiscard]] std::vector<Motion> find_motion(const TraceBody &body);

/// The percentile at `share` (0 to 1), by linear interpolation between the closest ranks; NaN without values. Sorts them.
[[nodiscard]] double percentile(std::vector<double> &values, double share);

/// In meters; NaN where there are no samples.
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
	/// `error` in meters; NaN counts as infinite. Samples of unknown motion are ignored.
	void add(double error, Motion motion);
	/// Adds the samples of another summary.
	void add(const ErrorSummary &other);
	[[nodiscard]] ErrorFigures figures() const;

private:
	std::vector<double> _moving;
	std::vector<double> _resting;
};

} // namespace bench
