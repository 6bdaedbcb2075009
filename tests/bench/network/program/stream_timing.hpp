#pragma once

#include "../stream_run.hpp"

namespace bench {

/// What a stream costs the processors at its two ends.
struct StreamTiming {
	double encode = 0.0; ///< sender's seconds for a pose observed: observe, flush and the answers
	double decode = 0.0; ///< receiver's seconds for a pose shown: packets, pictures and answers
	/// Allocations at both ends for a packet sent, from two seconds after the begin to the end of the trace.
	double sender_allocations = 0.0;
	double receiver_allocations = 0.0;
	bool repeats = false; ///< whether the sender, run again, sent the same number of bytes
};

/// Runs each end of a recorded stream again, by itself, with nothing of the benchmark between: medians of three.
[[nodiscard]] StreamTiming time_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const StreamResult &recorded);

} // namespace bench
