#include "stream_run.hpp"

#include "simulated_link.hpp"

#include "net/receiver.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

constexpr double SHORTEST_TICK = 1.0 / 240.0;
constexpr std::uint32_t RECEIVER = 1;
// The receiver's clock is ahead of the sender's by this, in seconds: they have nothing to do with each other.
constexpr double RECEIVER_EPOCH = 4321.0;
// Seconds at the begin of which the playback delay is not looked at.
constexpr double SETTLING = 1.0;

// Compares what a receiver shows with a trace, sample by sample as playback reaches them.
class ErrorProbe {
public:
	explicit ErrorProbe(const Trace &trace) :
			trace_(trace) {
		for (const TraceBody &body : trace.bodies) {
			motion_.push_back(find_motion(body));
		}
	}

	// Playback begins; what lies before was never shown.
	void begin(double media_time) {
		while (next_ < trace_.order.size() && next_time() < media_time) {
			++next_;
			++unseen_;
		}
	}

	// Looks at the samples up to a media time, before the receiver goes there.
	void look(const net::Receiver &receiver, double media_time) {
		for (; next_ < trace_.order.size() && next_time() <= media_time; ++next_) {
			const SampleIndex &index = trace_.order[next_];
			const std::uint32_t id = trace_.bodies[index.body].id;
			cga::Pose<double> pose;
			if (receiver.pose_at(id, next_time(), pose) || receiver.pose(id, pose)) {
				errors_.add(lever_distance(pose, trace_.sample(index).pose), motion_[index.body][index.sample]);
			} else {
				++unseen_;
			}
		}
	}

	[[nodiscard]] bool is_done() const { return next_ == trace_.order.size(); }
	[[nodiscard]] const ErrorSummary &errors() const { return errors_; }
	// Those that playback has not reached are unseen too.
	[[nodiscard]] std::size_t unseen() const { return unseen_ + trace_.order.size() - next_; }

private:
	// Media time begins at the trace's first sample.
	[[nodiscard]] double next_time() const { return trace_.sample(trace_.order[next_]).time - trace_.begin(); }

	const Trace &trace_;
	std::vector<std::vector<Motion>> motion_; // by body and sample
	ErrorSummary errors_;
	std::size_t next_ = 0; // in the trace's order
	std::size_t unseen_ = 0;
};

// A sender, a receiver and the two links between them. Times are the sender's.
class StreamRun {
public:
	StreamRun(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const LinkSettings &link, std::uint64_t seed) :
			trace_(trace), feed_(feed), sender_(settings), there_(link, seed), back_(link, ~seed), probe_(trace) {
		sender_.add_receiver(RECEIVER, trace.begin());
	}

	void step_source(const SourceStep &step) {
		result_.answers.begin(step.time);
		while (back_.receive(step.time, datagram_)) {
			result_.answers.add(datagram_);
			note(sender_.accept(RECEIVER, datagram_.data(), datagram_.size(), step.time), "an answer was refused");
		}
		result_.refused += feed_.feed(sender_, step);
		for (const net::OutgoingPacket &packet : sender_.packets()) {
			there_.send(step.time, sender_.bytes() + packet.begin, packet.size);
			result_.bytes_sent += packet.size;
			++result_.packets_sent;
			if (packet.size > std::size_t(net::MOST_PACKET_BYTES)) {
				note("too large", "a packet");
			}
		}
	}

	void show_picture(double time) {
		const double now = time + RECEIVER_EPOCH;
		result_.packets.begin(now);
		while (there_.receive(time, datagram_)) {
			result_.packets.add(datagram_);
			note(receiver_.accept(datagram_.data(), datagram_.size(), now), "a packet was refused");
		}
		if (!playing_ && receiver_.is_ready()) {
			playing_ = true;
			receiver_.advance(now);
			probe_.begin(receiver_.media_time());
		}
		if (playing_) {
			probe_.look(receiver_, receiver_.media_time_at(now));
			receiver_.advance(now);
			const double media_time = receiver_.media_time() + trace_.begin();
			if (time > trace_.begin() + SETTLING && media_time <= trace_.end()) {
				delays_.push_back(time - media_time);
			}
		}
		if (receiver_.take_answer(datagram_, now)) {
			answer_bytes_ += datagram_.size();
			back_.send(time, datagram_.data(), datagram_.size());
		}
	}

	[[nodiscard]] bool is_done() const { return probe_.is_done(); }

	StreamResult finish() {
		result_.method.subject = "ga_godot";
		result_.method.errors = probe_.errors();
		result_.method.unseen = probe_.unseen();
		result_.method.bytes_per_second = double(result_.bytes_sent) / trace_.duration();
		result_.method.packets_per_second = double(result_.packets_sent) / trace_.duration();
		result_.method.delay_median = percentile(delays_, 0.5);
		result_.method.delay_max = percentile(delays_, 1.0);
		result_.answer_bytes_per_second = double(answer_bytes_) / trace_.duration();
		return std::move(result_);
	}

private:
	void note(const char *error, const char *what) {
		if (error != nullptr && result_.problem.empty()) {
			result_.problem = std::string(what) + ": " + error;
		}
	}

	const Trace &trace_;
	const SourceFeed &feed_;
	net::Sender sender_;
	net::Receiver receiver_;
	SimulatedLink there_;
	SimulatedLink back_;
	ErrorProbe probe_;
	StreamResult result_;
	std::vector<double> delays_;
	std::vector<std::uint8_t> datagram_;
	std::uint64_t answer_bytes_ = 0;
	bool playing_ = false;
};

} // namespace

net::StreamSettings stream_settings(const Trace &trace, double tolerance) {
	net::StreamSettings settings;
	settings.position_tolerance = tolerance;
	// The angle that counts as much as the distance at LEVER: see net::StreamGrid.
	settings.rotation_tolerance = glm::degrees(std::sqrt(1.5) * tolerance / LEVER);
	settings.tick = std::max(trace.usual_interval(), SHORTEST_TICK);
	return settings;
}

void StreamRecording::add(const std::vector<std::uint8_t> &datagram) {
	bytes_.insert(bytes_.end(), datagram.begin(), datagram.end());
	begins_.push_back(bytes_.size());
	steps_.back().end = count();
}

StreamResult run_stream(const Trace &trace, const SourceFeed &feed, const net::StreamSettings &settings, const LinkSettings &link, std::uint64_t seed) {
	StreamRun run(trace, feed, settings, link, seed);
	// Half a picture off, so that a source of the same rate is neither lucky nor unlucky.
	const auto picture_time = [&](std::uint64_t number) { return trace.begin() + (double(number) + 0.5) / PICTURE_RATE; };
	std::uint64_t picture = 0;
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
