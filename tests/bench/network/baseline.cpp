#include "baseline.hpp"

#include "cga/motor/motor.hpp"
#include "net/stream/stream_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {

// A sample may precede its multiple of the send interval by this part of the sample interval: recorded times are rounded,
// and rates are never exactly the nominal ones.
constexpr double EARLY = 0.25;

cga::Pose<double> as_floats(const cga::Pose<double> &pose) {
	return cga::pose_cast<double>(cga::pose_cast<float>(pose));
}

// Eight float32 coefficients of the rigid motor and a float32 scale.
cga::Pose<double> as_float_motor(const cga::Pose<double> &pose) {
	cga::Pose<double> rigid = pose;
	rigid.scale = 1.0;
	const cga::Motor<double> motor = cga::Motor<double>::from_pose(rigid);
	cga::Motor<double> received;
	received.a = glm::dquat(glm::quat(motor.a));
	received.b = received.a;
	received.v = glm::dquat(glm::quat(motor.v));
	cga::Pose<double> result = received.to_pose().value_or(cga::Pose<double>());
	result.scale = float(pose.scale);
	return result;
}

// The samples that are sent, by ascending time.
std::vector<SampleIndex> choose_samples(const Trace &trace, double rate) {
	const double early = EARLY * std::min(trace.sample_interval(), 1.0 / rate);
	std::vector<double> next(trace.bodies.size(), trace.begin());
	std::vector<SampleIndex> chosen;
	for (const SampleIndex &index : trace.order) {
		const double time = trace.sample(index).time;
		const bool is_last = index.sample + 1 == trace.bodies[index.body].samples.size();
		if (time + early >= next[index.body] || index.sample == 0 || is_last) {
			chosen.push_back(index);
			next[index.body] = trace.begin() + (std::floor((time + early - trace.begin()) * rate) + 1.0) / rate;
		}
	}
	return chosen;
}

// The maximum interval between consecutive sent samples of a body, in seconds, gaps of the recording excluded.
double max_send_interval(const Trace &trace, const std::vector<SampleIndex> &chosen, double rate) {
	const double regular = 1.0 / rate + 1.5 * trace.sample_interval();
	std::vector<double> last(trace.bodies.size(), -std::numeric_limits<double>::infinity());
	double max_interval = 0.0;
	for (const SampleIndex &index : chosen) {
		const double interval = trace.sample(index).time - last[index.body];
		if (interval <= regular) {
			max_interval = std::max(max_interval, interval);
		}
		last[index.body] = trace.sample(index).time;
	}
	return max_interval > 0.0 ? max_interval : 1.0 / rate;
}

struct Cost {
	size_t poses = 0;
	size_t datagrams = 0;
};

// The cost of sending every body at every multiple of 1 / rate from its first to its last sample.
Cost fixed_rate_cost(const Trace &trace, double rate, size_t bodies_per_datagram) {
	Cost cost;
	const double early = EARLY / rate;
	for (size_t turn = 0; double(turn) / rate <= trace.duration() + early; ++turn) {
		const double time = trace.begin() + double(turn) / rate;
		const auto exists_at_time = [&](const TraceBody &body) { return body.samples.front().time - early <= time && time <= body.samples.back().time + early; };
		const size_t poses = size_t(std::count_if(trace.bodies.begin(), trace.bodies.end(), exists_at_time));
		cost.poses += poses;
		cost.datagrams += (poses + bodies_per_datagram - 1) / bodies_per_datagram;
	}
	return cost;
}

// The samples of each body that arrived in time, rounded as sent.
class ReceivedSamples {
public:
	explicit ReceivedSamples(const Trace &trace) :
			_samples(trace.bodies.size()) {}

	void add(uint32_t body, const TraceSample &sample) { _samples[body].push_back(sample); }

	// The pose shown at a time; null before the first sample. Valid until the next call.
	const cga::Pose<double> *show(uint32_t body, double time, cga::Mode path) {
		const std::vector<TraceSample> &samples = _samples[body];
		const auto after = std::upper_bound(samples.begin(), samples.end(), time, [](double t, const TraceSample &sample) { return t < sample.time; });
		if (after == samples.begin()) {
			return nullptr;
		}
		const TraceSample &from = *(after - 1);
		if (after == samples.end()) {
			return &from.pose;
		}
		_shown = cga::interpolate(from.pose, after->pose, (time - from.time) / (after->time - from.time), path);
		return &_shown;
	}

private:
	std::vector<std::vector<TraceSample>> _samples; // by body
	cga::Pose<double> _shown;
};

} // namespace

std::vector<Baseline> baselines() {
	std::vector<Baseline> all;
	for (const int rate : { 5, 10, 15, 20, 30, 60 }) {
		all.push_back({ "pqs_float32_" + std::to_string(rate) + "hz", double(rate), 40, cga::Mode::SEPARATE, as_floats });
	}
	for (const int rate : { 5, 10, 15, 30 }) {
		all.push_back({ "paper_motor_float32_" + std::to_string(rate) + "hz", double(rate), 36, cga::Mode::LINEAR, as_float_motor });
	}
	return all;
}

MethodResult run_baseline(const Trace &trace, const Baseline &baseline, const harness::LinkSettings &link, uint64_t seed) {
	const std::vector<SampleIndex> chosen = choose_samples(trace, baseline.rate);
	const double delay = max_send_interval(trace, chosen, baseline.rate) + link.delay + link.jitter;
	const size_t bodies_per_datagram = net::StreamSettings().max_packet_size / baseline.pose_bytes;
	ReceivedSamples received(trace);
	harness::LinkModel model(link, seed);
	for (size_t begin = 0, end = 0; begin < chosen.size(); begin = end) {
		const double time = trace.sample(chosen[begin]).time;
		while (end < chosen.size() && end - begin < bodies_per_datagram && trace.sample(chosen[end]).time == time) {
			++end;
		}
		const harness::DatagramFate fate = model.fate(time, (end - begin) * baseline.pose_bytes);
		const auto in_time = [&](double arrival) { return arrival <= time + delay; };
		if (std::none_of(fate.arrivals.begin(), fate.arrivals.begin() + fate.copies, in_time)) {
			continue;
		}
		for (size_t i = begin; i < end; ++i) {
			received.add(chosen[i].body, { time, baseline.as_received(trace.sample(chosen[i]).pose) });
		}
	}

	MethodResult result;
	result.subject = baseline.subject;
	const Cost cost = fixed_rate_cost(trace, baseline.rate, bodies_per_datagram);
	result.bytes_per_second = double(cost.poses * baseline.pose_bytes) / trace.duration();
	result.packets_per_second = double(cost.datagrams) / trace.duration();
	result.delay_median = result.delay_max = delay;
	for (uint32_t body = 0; body < trace.bodies.size(); ++body) {
		const std::vector<TraceSample> &samples = trace.bodies[body].samples;
		const std::vector<Motion> motion = find_motion(trace.bodies[body]);
		for (size_t i = 0; i < samples.size(); ++i) {
			if (const cga::Pose<double> *shown = received.show(body, samples[i].time, baseline.path)) {
				result.errors.add(lever_distance(*shown, samples[i].pose), motion[i]);
			} else {
				++result.unseen;
			}
		}
	}
	return result;
}

} // namespace bench
