#pragma once

#include "pose_error.hpp"

#include <string>

namespace bench {

/// What sending a trace by one method came to.
struct MethodResult {
	std::string subject; ///< the method's name in rows
	ErrorSummary errors;
	double bytes_per_second = 0.0; ///< to one receiver, over the trace's duration
	double packets_per_second = 0.0;
	double delay_median = 0.0; ///< seconds that what is shown lies behind the source
	double delay_max = 0.0; ///< the same, the largest after the first second
	size_t unseen = 0; ///< samples of bodies before the receiver had anything to show of them
};

/// Several runs of one method with different chances as one: all their errors together, the longest delay, means of the
/// rest. At least one run.
[[nodiscard]] MethodResult pool_runs(const std::vector<MethodResult> &runs);

} // namespace bench
