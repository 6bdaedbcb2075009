#include "source_feed.hpp"

#include <algorithm>

namespace bench {

namespace {

// Seconds after which a body without samples is gone, and seconds without any sample that are a gap.
constexpr double GONE = 0.25;
constexpr double GAP = 0.05;
// Seconds between two flushes without poses.
constexpr double EMPTY_STEP = 1.0 / 60.0;

} // namespace

SourceFeed::SourceFeed(const Trace &trace, double tick, double drain) :
		_trace(trace) {
	const double gap = std::max(GAP, 3.0 * tick);
	const double empty_step = std::max(EMPTY_STEP, tick);
	const auto fill_until = [&](double end) {
		if (end - _steps.back().time <= gap) {
			return;
		}
		for (double time = _steps.back().time + empty_step; time < end - tick / 2.0; time += empty_step) {
			_steps.push_back({ time, 0, 0, 0, 0 });
		}
	};
	for (const TraceFrame &frame : trace.frames) {
		if (!_steps.empty()) {
			fill_until(frame.time);
		}
		_steps.push_back({ frame.time, frame.begin, frame.end, 0, 0 });
	}
	fill_until(trace.end() + drain);

	const double rto = std::max(GONE, 3.0 * trace.usual_interval());
	std::vector<std::pair<double, uint32_t>> ends;
	for (uint32_t body = 0; body < trace.bodies.size(); ++body) {
		const double found = trace.bodies[body].samples.back().time + rto;
		if (found < trace.end()) {
			ends.emplace_back(found, body);
		}
	}
	std::sort(ends.begin(), ends.end());
	for (SourceStep &step : _steps) {
		step.gone_begin = _gone.size();
		while (_gone.size() < ends.size() && ends[_gone.size()].first <= step.time) {
			_gone.push_back(ends[_gone.size()].second);
		}
		step.gone_end = _gone.size();
	}
}

size_t SourceFeed::feed(net::Sender &sender, const SourceStep &step) const {
	size_t refused = 0;
	for (size_t i = step.gone_begin; i < step.gone_end; ++i) {
		sender.remove_body(_trace.bodies[_gone[i]].id);
	}
	for (size_t i = step.begin; i < step.end; ++i) {
		const SampleIndex &index = _trace.order[i];
		const uint32_t id = _trace.bodies[index.body].id;
		const cga::Pose<double> &pose = _trace.sample(index).pose;
		if (index.sample == 0) {
			sender.add_body(id, pose);
		}
		refused += !sender.observe(id, step.time, pose);
	}
	sender.flush(step.time);
	return refused;
}

} // namespace bench
