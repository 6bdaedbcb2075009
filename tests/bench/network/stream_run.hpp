#pragma once

#include "../../harness/link_model.hpp"
#include "method_result.hpp"
#include "source_feed.hpp"

#include "net/stream_settings.hpp"

namespace bench {

/// The settings with which a trace is sent: error at most `tolerance` metres, at the centre and at LEVER, at the ticks
/// of the trace; not shorter ones than 1/240 s.
[[nodiscard]] net::StreamSettings stream_settings(const Trace &trace, double tolerance);

/// What passed between a sender and a receiver, and when, so that each can be run again by itself.
class StreamRecording {
public:
	struct Datagrams {
		double time = 0.0; ///< when they were taken, on the taker's clock
		size_t begin = 0; ///< among datagrams
		size_t end = 0;
	};

	/// Begins what is taken at a time.
	void begin(double time) { _steps.push_back({ time, count(), count() }); }
	void add(const std::vector<uint8_t> &datagram);

	/// One for each step of the sender, or picture of the receiver.
	[[nodiscard]] const std::vector<Datagrams> &steps() const { return _steps; }
	[[nodiscard]] const uint8_t *bytes(size_t datagram) const { return _bytes.data() + _begins[datagram]; }
	[[nodiscard]] size_t size(size_t datagram) const { return _begins[datagram + 1] - _begins[datagram]; }

private:
	[[nodiscard]] size_t count() const { return _begins.size() - 1; }

	std::vector<Datagrams> _steps;
	std::vector<size_t> _begins{ 0 };
	std::vector<uint8_t> _bytes;
};

struct StreamResult {
	MethodResult method;
	double answer_bytes_per_second = 0.0; ///< from the receiver to the sender
	uint64_t bytes_sent = 0;
	uint64_t packets_sent = 0;
	size_t refused = 0; ///< poses that the sender did not take
	std::string problem; ///< empty, or what went wrong
	StreamRecording answers; ///< as the sender took them, by source step
	StreamRecording packets; ///< as the receiver took them, by picture
};

/// Pictures that a receiver shows in a second.
inline constexpr double PICTURE_RATE = 60.0;

/// Sends the trace with a net::Sender through a link to a net::Receiver, and the answers back through another such link.
///
/// The receiver takes packets and shows a picture 60 times a second. Nothing is drawn between pictures, so a sample
/// counts as the first picture that has reached its time would show it; if the body's motion is not known up to there,
/// as the body is shown. Samples of bodies, or of times, that the receiver never had anything to show of are unseen.
[[nodiscard]] StreamResult run_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const harness::LinkSettings &link, uint64_t seed);

} // namespace bench
