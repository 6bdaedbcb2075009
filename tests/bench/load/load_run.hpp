#pragma once

#include "load_scenario.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/// What the receivers of a group measured. Errors are in meters, as docs/performance/network.md defines them; bytes are those of
/// packets without UDP and IP headers.
struct GroupResult {
	std::string name;
	size_t receivers = 0;
	double bytes_per_second = 0.0; ///< sent to one receiver, mean over the group
	double packets_per_second = 0.0; ///< the same
	double ack_bytes_per_second = 0.0; ///< from one receiver, mean
	double burst = 0.0; ///< maximum over the receivers of the bytes in one tick above the receiver's mean per tick
	double burst_p999 = 0.0; ///< 99.9 % of the ticks have less above the mean; maximum over the receivers
	double early_burst = 0.0; ///< bytes in one tick before the measured time, maximum
	double error_p50 = 0.0; ///< of moving bodies
	double error_p99 = 0.0;
	double error_max = 0.0;
	double resting_error_max = 0.0;
	double unseen_share = 0.0; ///< of the measured poses of bodies that should have been shown
	double frozen_share = 0.0; ///< of the frames, in which nothing new was shown; the worst receiver
	double longest_stall = 0.0; ///< the longest time in which nothing new was shown, in seconds
	double delay_median = 0.0; ///< playback delay, in seconds
	double delay_max = 0.0;
	double ready_after = 0.0; ///< seconds from the join to the first frame with bodies, maximum
	double snapshots = 0.0; ///< decoded by one receiver, mean
	double retransmissions = 0.0; ///< of chunks and fragments to one receiver, mean
	double dropped = 0.0; ///< datagrams that the bottleneck dropped, mean, all the time
	double core_share = 0.0; ///< of one receiver, mean
	double frame_ns = 0.0; ///< processor time of one frame of one receiver, mean
	double memory = 0.0; ///< allocated bytes in use of one receiver, peak, mean
	double memory_growth = 0.0; ///< bytes per simulated minute, mean; NaN for runs under a minute
	uint64_t rejected = 0; ///< packets, all receivers
};

struct LoadResult {
	std::string name;
	double seconds = 0.0; ///< measured virtual time
	bool is_cut = false; ///< the run ended early, at the limit of the processor time
	double core_share = 0.0; ///< of the sender
	double tick_ns = 0.0; ///< processor time of one tick of the sender
	double tick_ns_max = 0.0; ///< of one tick
	double memory = 0.0; ///< allocated bytes in use of the sender, peak
	double memory_growth = 0.0; ///< bytes per simulated minute; NaN for runs under a minute
	uint64_t rejected = 0; ///< poses and packets that the sender rejected
	std::vector<GroupResult> groups;
};

/// Runs a scenario in virtual time: the sender ticks at the rate of its settings, each receiver shows 60 frames per second.
[[nodiscard]] LoadResult run_load(const LoadScenario &scenario);

} // namespace bench
