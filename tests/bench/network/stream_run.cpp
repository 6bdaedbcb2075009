#include "stream_run.hpp"

#include "../../harness/simulated_link.hpp"

#include "net/endpoint/receiver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bench {

namespace {

constexpr double MIN_TICK = 1.0 / 240.0;
constexpr uint32_t RECEIVER = 1;
// Seconds by which the receiver's clock is ahead of the sender's: clocks are not synchronized.
constexpr double RECEIVER_EPOCH = 4321.0;
// Playback delays of the first seconds are not measured.
constexpr double SETTLING = 1.0;

// Compares a receiver's poses with the trace, sample by sample, as playback reaches them.
class ErrorProbe {
public:
	explicit ErrorProbe(const Trace &trace) :
			_trace(trace) {
		for (const TraceBody &body : trace.bodies) {
			_motion.push_back(find_motion(body));
		}
	}

	// Playback begins; samples before it are unseen.
	void begin(double media_time) {
		while (_next < _trace.order.size() && next_time() < media_time) {
			++_next;
			++_unseen;
		}
	}

	// Measures the samples up to a media time, before the receiver advances to it.
	void measure(const net::Receiver &receiver, double media_time) {
		for (; _next < _trace.order.size() && next_time() <= media_time; ++_next) {
			const SampleIndex &index = _trace.order[_next];
			const uint32_t id = _trace.bodies[index.body].id;
			std::optional<cga::Pose<double>> pose = receiver.pose_at(id, next_time());
			if (!pose) {
				pose = receiver.pose(id);
			}
			if (pose) {
				_errors.add(lever_distance(*pose, _trace.sample(index).pose), _motion[index.body][index.sample]);
			} else {
				++_unseen;
			}
		}
	}

	[[nodiscard]] bool is_done() const { return _next == _trace.order.size(); }
	[[nodiscard]] const ErrorSummary &errors() const { return _errors; }
	// Includes the samples that playback has not reached.
	[[nodiscard]] size_t unseen() const { return _unseen + _trace.order.size() - _next; }

private:
	// As media time, which begins at the trace's first sample.
	[[nodiscard]] double next_time() const { return _trace.sample(_trace.order[_next]).time - _trace.begin(); }

	const Trace &_trace;
	std::vector<std::vector<Motion>> _motion; // by body and sample
	ErrorSummary _errors;
	size_t _next = 0; // in Trace::order
	size_t _unseen = 0;
};

// A sender, a receiver and the two links between them. Times are on the sender's clock.
class StreamRun {
public:
	StreamRun(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const harness::LinkSettings &link, uint64_t seed) :
			_trace(trace), _feed(feed), _sender(settings), _down(link, seed), _up(link, ~seed), _probe(trace) {
		_sender.add_receiver(RECEIVER, trace.begin());
	}

	void step_source(const SourceStep &step) {
		_result.acks.begin(step.time);
		while (const std::optional<harness::Delivery> delivery = _up.receive(step.time)) {
			_result.acks.add(delivery->bytes);
			note(_sender.accept(RECEIVER, delivery->bytes.data(), delivery->bytes.size(), step.time), "the sender rejected an acknowledgement");
		}
		_result.rejected += _feed.feed(_sender, step);
		for (const net::OutgoingPacket &packet : _sender.packets()) {
			_down.send(step.time, _sender.bytes() + packet.begin, packet.size);
			_result.bytes_sent += packet.size;
			++_result.packets_sent;
			if (packet.size > net::StreamSettings().max_packet_size) {
				note(net::PacketError::TOO_LONG, "the sender sent an invalid packet");
			}
		}
	}

	void show_frame(double time) {
		const double now = time + RECEIVER_EPOCH;
		_result.packets.begin(now);
		while (const std::optional<harness::Delivery> delivery = _down.receive(time)) {
			_result.packets.add(delivery->bytes);
			note(_receiver.accept(delivery->bytes.data(), delivery->bytes.size(), now), "the receiver rejected a packet");
		}
		if (!_playing && _receiver.is_ready()) {
			_playing = true;
			_receiver.advance(now);
			_probe.begin(_receiver.media_time());
		}
		if (_playing) {
			_probe.measure(_receiver, _receiver.media_time_at(now));
			_receiver.advance(now);
			const double media_time = _receiver.media_time() + _trace.begin();
			if (time > _trace.begin() + SETTLING && media_time <= _trace.end()) {
				_delays.push_back(time - media_time);
			}
		}
		_receiver.take_ack(_ack, now);
		if (!_ack.empty()) {
			_ack_bytes += _ack.size();
			_up.send(time, _ack.data(), _ack.size());
		}
	}

	[[nodiscard]] bool is_done() const { return _probe.is_done(); }

	StreamResult finish() {
		_result.method.subject = "ga_godot";
		_result.method.errors = _probe.errors();
		_result.method.unseen = _probe.unseen();
		_result.method.bytes_per_second = double(_result.bytes_sent) / _trace.duration();
		_result.method.packets_per_second = double(_result.packets_sent) / _trace.duration();
		_result.method.delay_median = percentile(_delays, 0.5);
		_result.method.delay_max = percentile(_delays, 1.0);
		_result.ack_bytes_per_second = double(_ack_bytes) / _trace.duration();
		return std::move(_result);
	}

private:
	void note(const net::PacketResult &result, const char *what) {
		if (!result && _result.problem.empty()) {
			_result.problem = std::string(what) + ": " + net::describe(result.error());
		}
	}

	const Trace &_trace;
	const SourceFeed &_feed;
	net::Sender _sender;
	net::Receiver _receiver;
	harness::SimulatedLink _down;
	harness::SimulatedLink _up;
	ErrorProbe _probe;
	StreamResult _result;
	std::vector<double> _delays;
	std::vector<uint8_t> _ack;
	uint64_t _ack_bytes = 0;
	bool _playing = false;
};

} // namespace

net::StreamSettings stream_settings(const Trace &trace, double tolerance) {
	net::StreamSettings settings;
	settings.position_tolerance = tolerance;
	// The angle that weighs as much as the tolerance at LEVER_ARM: see net::StreamGrid.
	settings.rotation_tolerance = glm::degrees(std::sqrt(1.5) * tolerance / LEVER_ARM);
	settings.tick = std::max(trace.sample_interval(), MIN_TICK);
	return settings;
}

void StreamRecording::add(const std::vector<uint8_t> &datagram) {
	_bytes.insert(_bytes.end(), datagram.begin(), datagram.end());
	_begins.push_back(_bytes.size());
	_steps.back().end = count();
}

StreamResult run_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const harness::LinkSettings &link, uint64_t seed) {
	StreamRun run(trace, feed, settings, link, seed);
	// Half a frame out of phase, so that a source of the same rate is neither at an advantage nor at a disadvantage.
	const auto frame_time = [&](uint64_t number) { return trace.begin() + (double(number) + 0.5) / FRAME_RATE; };
	uint64_t frame = 0;
	for (const SourceStep &step : feed.steps()) {
		for (; frame_time(frame) < step.time; ++frame) {
			run.show_frame(frame_time(frame));
		}
		if (run.is_done()) {
			break;
		}
		run.step_source(step);
	}
	return run.finish();
}

} // namespace bench
