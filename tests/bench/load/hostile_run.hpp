#pragma once

#include "hostile_peer.hpp"

#include <cstdint>

namespace bench {

/// A server, which owns most bodies, honest clients, which own a few each, and a hostile client, which owns one.
struct HostileScenario {
	Attack attack = Attack::FRESH_IDS;
	size_t bodies = 1000; ///< of the server
	size_t clients = 3; ///< honest
	double packets_per_second = 10000.0;
	double seconds = 5.0; ///< of each of the two phases, without and with the attack
	uint64_t seed = 1;
	// The run ends early beyond either.
	double cpu_limit = 120.0; ///< processor seconds of the attack
	double memory_limit = 1e9; ///< allocated bytes in use at the server
};

/// What was measured in one of the phases.
struct HostilePhase {
	double frame = 0.0; ///< processor time of the server's frame in seconds, mean
	double frame_max = 0.0;
	double memory = 0.0; ///< allocated bytes in use at the server, peak
	double error_p99 = 0.0; ///< of the server's bodies at honest clients and of theirs at the server, in meters
	double delay_median = 0.0; ///< playback delay there, in seconds
	double longest_stall = 0.0; ///< of playback there, in seconds
	double client_bytes_per_second = 0.0; ///< from the server to an honest client, mean
	double hostile_bytes_per_second = 0.0; ///< from the server to the hostile one
};

struct HostileResult {
	HostilePhase before;
	HostilePhase during;
	double seconds = 0.0; ///< of the second phase
	uint64_t packets = 0; ///< hostile
	uint64_t bytes = 0;
	uint64_t rejected = 0; ///< of them, by the server
	bool is_cut = false;
};

[[nodiscard]] HostileResult run_hostile(const HostileScenario &scenario);

/// What a peer gets that requests streams and acknowledges nothing.
struct Amplification {
	uint64_t bytes_in = 0; ///< of its requests
	uint64_t bytes_out = 0; ///< to it, in all
	double ratio = 0.0; ///< the largest of bytes out to bytes in at any time
};

/// `requests` opens with different links, `interval` seconds apart, at a server of `bodies` moving bodies; 10 seconds.
[[nodiscard]] Amplification measure_amplification(size_t bodies, size_t requests, double interval);

} // namespace bench
