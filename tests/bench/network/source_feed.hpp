#pragma once

#include "trace.hpp"

#include "net/endpoint/sender.hpp"

namespace bench {

/// One tick of the source: the samples it observes and the bodies it removes.
struct SourceStep {
	double time = 0.0; ///< seconds
	size_t begin = 0; ///< in Trace::order
	size_t end = 0;
	size_t removed_begin = 0; ///< in SourceFeed's list
	size_t removed_end = 0;
};

/// Feeds a trace to a sender as a game would: observes every body at its sample times, then flushes. In gaps of the trace,
/// and for a while after its end, it flushes without poses. A body is added with its first sample and removed a quarter of
/// a second, or three sample intervals, after its last.
class SourceFeed {
public:
	/// `tick`: that of the stream; `drain`: how long to continue after the end of the trace; both in seconds.
	SourceFeed(const Trace &trace, double tick, double drain);

	[[nodiscard]] const std::vector<SourceStep> &steps() const { return _steps; }
	/// Feeds the step to the sender and flushes. Returns the number of poses that the sender rejected.
	size_t feed(net::Sender &sender, const SourceStep &step) const;

private:
	const Trace &_trace;
	std::vector<SourceStep> _steps;
	std::vector<uint32_t> _removed; // indices into Trace::bodies, by the time of removal
};

} // namespace bench
