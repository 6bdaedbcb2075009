#pragma once

#include "pose_error.hpp"

#include <string>

namespace bench {

/// Cost and error of replicating a trace with one method.
struct MethodResult {
	std::string subject; ///< the method's name in the rows
	ErrorSummary errors;
	double bytes_per_second = 0.0; ///< to one receiver, over the trace's duration
	double packets_per_second = 0.0;
	double delay_median = 0.0; ///< median playback delay relative to the source, in seconds
	double delay_max = 0.0; ///< maximum after the first second
	size_t unseen = 0; ///< samples at times when the receiver did not show their body
};

/// Combines at least one run of the same method with different seeds: pooled errors, the maximum delay, means of the rest.
[[nodiscard]] MethodResult pool_runs(const std::vector<MethodResult> &runs);

} // namespace bench
