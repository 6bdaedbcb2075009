#pragma once

#include "../../../harness/link_model.hpp"

#include "net/stream/stream_settings.hpp"

#include <cstddef>
#include <string>

namespace bench {

struct ServerLoadSettings {
	size_t bodies = 1000;
	size_t receivers = 64;
	double observe_rate = 60.0; ///< poses per second and body
	double seconds = 10.0; ///< measured, after a warm-up of 2 s
	harness::LinkSettings link; ///< each way, for each receiver
};

struct ServerLoad {
	double core_share = 0.0; ///< processor time of the sender / duration of the stream
	double bytes_per_second = 0.0; ///< to all receivers
	double packets_per_second = 0.0;
	std::string problem; ///< the first failure; empty if there was none
};

/// Replicates bodies that all move all the time, on Lissajous paths with a millimeter of noise, to many receivers. Measures
/// the sender: observations, packets and acknowledgements.
[[nodiscard]] ServerLoad measure_server_load(const ServerLoadSettings &load, const net::StreamSettings &stream, uint64_t seed);

} // namespace bench
