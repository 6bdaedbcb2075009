#pragma once

#include "../../../harness/link_model.hpp"

#include "net/stream_settings.hpp"

#include <cstddef>
#include <string>

namespace bench {

struct ServerLoadSettings {
	size_t bodies = 1000;
	size_t receivers = 64;
	double observe_rate = 60.0; ///< poses a second of each body
	double seconds = 10.0; ///< measured, after two more
	harness::LinkSettings link; ///< to each receiver and back
};

struct ServerLoad {
	double core_share = 0.0; ///< processor time of the sender's thread / time that passed in the stream
	double bytes_per_second = 0.0; ///< to all receivers together
	double packets_per_second = 0.0;
	std::string problem; ///< empty, or what went wrong
};

/// Bodies that all move all the time, on Lissajous paths with a millimetre of noise, sent to many receivers. Observing,
/// making packets and taking answers are timed; links and receivers are not.
[[nodiscard]] ServerLoad measure_server_load(const ServerLoadSettings &load, const net::StreamSettings &stream, uint64_t seed);

} // namespace bench
