#pragma once

#include "../stream_run.hpp"

namespace bench {

/// Processor time and allocations of the two ends of a stream.
struct StreamTiming {
	double encode = 0.0; ///< seconds of the sender per observed pose: observe, flush, acknowledgements
	double decode = 0.0; ///< seconds of the receiver per shown pose: packets, playback, acknowledgements
	/// Allocations per packet, from 2 s after the beginning of the trace to its end.
	double sender_allocations = 0.0;
	double receiver_allocations = 0.0;
	bool is_deterministic = false; ///< whether the sender, run again, sent the same number of bytes
};

/// Runs each end of a recorded stream again without the other, three times, and returns the figures of the median runs.
[[nodiscard]] StreamTiming time_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const StreamResult &recorded);

} // namespace bench
