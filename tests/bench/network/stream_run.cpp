#include "stream_run.hpp"

#include "../../harness/simulated_link.hpp"

#include "net/receiver.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

constexpr double MIN_TICK = 1.0 / 240.0;
constexpr uint32_t RECEIVER = 1;
// The receiver's clock is ahead of the sender's by this, in seconds: they have nothing to do with each other.
constexpr double RECEIVER_EPOCH = 4321.0;
// Seconds at the begin of which the playback delay is not looked at.
constexpr double SETTLING = 1.0;

// Compares what a receiver shows with a trace, sample by sample as playback reaches them.
class ErrorProbe {
public:
	explicit ErrorProbe(const Trace &trace) :
			_trace(trace) {
		for (const TraceBody &body : trace.bodies) {
			_motion.push_back(find_motion(body));
		}
	}

	// Playback begins; what lies before was never shown.
	void begin(double media_time) {
		while (_next < _trace.order.size() && next_time() < media_time) {
			++_next;
			++_unseen;
		}
	}

	// Looks at the samples up to a media time, before the receiver goes there.
	void look(const net::Receiver &receiver, double media_time) {
		for (; _next < _trace.order.size() && next_time() <= media_time; ++_next) {
			const SampleIndex &index = _trace.order[_next];
			const uint32_t id = _trace.bodies[index.body].id;
			cga::Pose<double> pose;
			if (receiver.pose_at(id, next_time(), pose) || receiver.pose(id, pose)) {
				_errors.add(lever_distance(pose, _trace.sample(index).pose), _motion[index.body][index.sample]);
			} else {
				++_unseen;
			}
		}
	}

	[[nodiscard]] bool is_done() const { return _next == _trace.order.size(); }
	[[nodiscard]] const ErrorSummary &errors() const { return _errors; }
	// Those that playback has not reached are unseen too.
	[[nodiscard]] size_t unseen() const { return _unseen + _trace.order.size() - _next; }

private:
	// Media time begins at the trace's first sample.
	[[nodiscard]] double next_time() const { return _trace.sample(_trace.order[_next]).time - _trace.begin(); }

	const Trace &_trace;
	std::vector<std::vector<Motion>> _motion; // by body and sample
	ErrorSummary _errors;
	size_t _next = 0; // in the trace's order
	size_t _unseen = 0;
};

// A sender, a receiver and the two links between them. Times are the sender's.
class StreamRun {
public:
	StreamRun(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const harness::LinkSettings &link, uint64_t seed) :
			_trace(trace), _feed(feed), _sender(settings), _there(link, seed), _back(link, ~seed), _probe(trace) {
		_sender.add_receiver(RECEIVER, trace.begin());
	}

	void step_source(const SourceStep &step) {
		_result.answers.begin(step.time);
		while (const std::optional<harness::Delivery> delivery = _back.receive(step.time)) {
			_result.answers.add(delivery->bytes);
			note(_sender.accept(RECEIVER, delivery->bytes.data(), delivery->bytes.size(), step.time), "an answer was refused");
		}
		_result.refused += _feed.feed(_sender, step);
		for (const net::OutgoingPacket &packet : _sender.packets()) {
			_there.send(step.time, _sender.bytes() + packet.begin, packet.size);
			_result.bytes_sent += packet.size;
			++_result.packets_sent;
			if (packet.size > size_t(net::MAX_PACKET_BYTES)) {
				note("too large", "a packet");
			}
		}
	}

	void show_picture(double time) {
		const double now = time + RECEIVER_EPOCH;
		_result.packets.begin(now);
		while (const std::optional<harness::Delivery> delivery = _there.receive(time)) {
			_result.packets.add(delivery->bytes);
			note(_receiver.accept(delivery->bytes.data(), delivery->bytes.size(), now), "a packet was refused");
		}
		if (!_playing && _receiver.is_ready()) {
			_playing = true;
			_receiver.advance(now);
			_probe.begin(_receiver.media_time());
		}
		if (_playing) {
			_probe.look(_receiver, _receiver.media_time_at(now));
			_receiver.advance(now);
			const double media_time = _receiver.media_time() + _trace.begin();
			if (time > _trace.begin() + SETTLING && media_time <= _trace.end()) {
				_delays.push_back(time - media_time);
			}
		}
		if (_receiver.take_answer(_answer, now)) {
			_answer_bytes += _answer.size();
			_back.send(time, _answer.data(), _answer.size());
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
		_result.answer_bytes_per_second = double(_answer_bytes) / _trace.duration();
		return std::move(_result);
	}

private:
	void note(const char *error, const char *what) {
		if (error != nullptr && _result.problem.empty()) {
			_result.problem = std::string(what) + ": " + error;
		}
	}

	const Trace &_trace;
	const SourceFeed &_feed;
	net::Sender _sender;
	net::Receiver _receiver;
	harness::SimulatedLink _there;
	harness::SimulatedLink _back;
	ErrorProbe _probe;
	StreamResult _result;
	std::vector<double> _delays;
	std::vector<uint8_t> _answer;
	uint64_t _answer_bytes = 0;
	bool _playing = false;
};

} // namespace

net::StreamSettings stream_settings(const Trace &trace, double tolerance) {
	net::StreamSettings settings;
	settings.position_tolerance = tolerance;
	// The angle that counts as much as the distance at LEVER: see net::StreamGrid.
	settings.rotation_tolerance = glm::degrees(std::sqrt(1.5) * tolerance / LEVER);
	settings.tick = std::max(trace.usual_interval(), MIN_TICK);
	return settings;
}

void StreamRecording::add(const std::vector<uint8_t> &datagram) {
	_bytes.insert(_bytes.end(), datagram.begin(), datagram.end());
	_begins.push_back(_bytes.size());
	_steps.back().end = count();
}

StreamResult run_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const harness::LinkSettings &link, uint64_t seed) {
	StreamRun run(trace, feed, settings, link, seed);
	// Half a picture off, so that a source of the same rate is neither lucky nor unlucky.
	const auto picture_time = [&](uint64_t number) { return trace.begin() + (double(number) + 0.5) / PICTURE_RATE; };
	uint64_t picture = 0;
	for (const SourceStep &step : feed.steps()) {
		for (; picture_time(picture) < step.time; ++picture) {
			run.show_picture(picture_time(picture));
		}
		if (run.is_done()) {
			break;
		}
		run.step_source(step);
	}
	return run.finish();
}

} // namespace bench
