#pragma once

#include "trace.hpp"

#include "net/endpoint/sender.hpp"

namespace bench {

/// One tick of the source: what is observed, and which bodies are found to be gone.
struct SourceStep {
	double time = 0.0; ///< seconds
	size_t begin = 0; ///< in Trace::order
	size_t end = 0;
	size_t gone_begin = 0; ///< in SourceFeed's list
	size_t gone_end = 0;
};

/// Feeds a trace to a sender as a game would: every body's pose at its source times, then a flush. In gaps, and for a
/// while after the end, it flushes without poses. A body appears with its first sample; one without further samples
/// vanishes a quarter of a second after its last.
class SourceFeed {
public:
	/// `tick` is that of the stream, `drain` the time to go on after the end, both in seconds.
	SourceFeed(const Trace &trace, double tick, double drain);

	[[nodiscard]] const std::vector<SourceStep> &steps() const { return _steps; }
	/// Gives the step to the sender and flushes. The number of poses that it refused.
	size_t feed(net::Sender &sender, const SourceStep &step) const;

private:
	const Trace &_trace;
	std::vector<SourceStep> _steps;
	std::vector<uint32_t> _gone; // bodies' places, by the time when they are found to be gone
};

} // namespace bench
