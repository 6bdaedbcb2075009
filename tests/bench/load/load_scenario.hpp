#pragma once

#include "line.hpp"

#include "net/stream/stream_settings.hpp"

#include <string>
#include <vector>

namespace bench {

/// Receivers with equal lines.
struct ReceiverGroup {
	std::string name = "all";
	size_t count = 1;
	LineSettings down; ///< to the receivers
	LineSettings up; ///< back to the sender
	double join = 0.0; ///< when they join, in seconds
};

/// A sender of moving bodies and its receivers.
struct LoadScenario {
	std::string name;
	size_t bodies = 1000;
	double moving_share = 1.0; ///< of the bodies, 0 to 1
	std::vector<ReceiverGroup> groups;
	double seconds = 25.0; ///< of virtual time, with the warm-up
	double warm_up = 5.0; ///< from which to measure; groups that join are measured from their join on
	net::StreamSettings stream;
	uint64_t seed = 1;
	double cpu_limit = 120.0; ///< processor seconds, after which the run ends early
};

/// Settings for a tolerance in meters, at the center and at LEVER_ARM.
[[nodiscard]] net::StreamSettings load_settings(double tolerance, double max_latency);

} // namespace bench
