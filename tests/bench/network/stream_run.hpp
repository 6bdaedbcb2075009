#pragma once

#include "../../harness/link_model.hpp"
#include "method_result.hpp"
#include "source_feed.hpp"

#include "net/stream/stream_settings.hpp"

namespace bench {

/// Settings for a trace: an error of at most `tolerance` meters at the center and at LEVER_ARM, and a tick of the trace's
/// sample interval, but at least 1/240 s.
[[nodiscard]] net::StreamSettings stream_settings(const Trace &trace, double tolerance);

/// The datagrams that one end of a stream received, by step, so that it can be run again without the other end.
class StreamRecording {
public:
	struct Step {
		double time = 0.0; ///< on the receiving end's clock, in seconds
		size_t begin = 0; ///< index of its first datagram
		size_t end = 0;
	};

	/// Begins a step.
	void begin(double time) { _steps.push_back({ time, count(), count() }); }
	void add(const std::vector<uint8_t> &datagram);

	/// One for each step of the sender, or each frame of the receiver.
	[[nodiscard]] const std::vector<Step> &steps() const { return _steps; }
	[[nodiscard]] const uint8_t *bytes(size_t datagram) const { return _bytes.data() + _begins[datagram]; }
	[[nodiscard]] size_t size(size_t datagram) const { return _begins[datagram + 1] - _begins[datagram]; }

private:
	[[nodiscard]] size_t count() const { return _begins.size() - 1; }

	std::vector<Step> _steps;
	std::vector<size_t> _begins{ 0 };
	std::vector<uint8_t> _bytes;
};

struct StreamResult {
	MethodResult method;
	double ack_bytes_per_second = 0.0; ///< from the receiver to the sender
	uint64_t bytes_sent = 0;
	uint64_t packets_sent = 0;
	size_t rejected = 0; ///< poses that the sender rejected
	std::string problem; ///< the first failure; empty if there was none
	StreamRecording acks; ///< as the sender received them, by source step
	StreamRecording packets; ///< as the receiver received them, by frame
};

/// Frames per second that a receiver shows.
inline constexpr double FRAME_RATE = 60.0;

/// Replicates the trace from a net::Sender to a net::Receiver over a link, with a second link for the acknowledgements.
///
/// The receiver accepts packets and shows a frame 60 times a second. The error of a sample is that of the pose at the
/// sample's time, as known at the first frame whose media time has reached it; if the body's motion is not known up to
/// there, that of the pose shown last. Samples at times when the receiver did not show their body are unseen.
[[nodiscard]] StreamResult run_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const harness::LinkSettings &link, uint64_t seed);

} // namespace bench
