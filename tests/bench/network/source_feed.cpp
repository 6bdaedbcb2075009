#include "source_feed.hpp"

#include <algorithm>

namespace bench {

namespace {

// In seconds: time without samples after which a body is removed; minimum of a gap; interval of flushes in a gap.
constexpr double REMOVAL_DELAY = 0.25;
constexpr double GAP = 0.05;
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

	const double removal_delay = std::max(REMOVAL_DELAY, 3.0 * trace.sample_interval());
	std::vector<std::pair<double, uint32_t>> removals;
	for (uint32_t body = 0; body < trace.bodies.size(); ++body) {
		const double removal = trace.bodies[body].samples.back().time + removal_delay;
		if (removal < trace.end()) {
			removals.emplace_back(removal, body);
		}
	}
	std::sort(removals.begin(), removals.end());
	for (SourceStep &step : _steps) {
		step.removed_begin = _removed.size();
		while (_removed.size() < removals.size() && removals[_removed.size()].first <= step.time) {
			_removed.push_back(removals[_removed.size()].second);
		}
		step.removed_end = _removed.size();
	}
}

size_t SourceFeed::feed(net::Sender &sender, const SourceStep &step) const {
	size_t rejected = 0;
	for (size_t i = step.removed_begin; i < step.removed_end; ++i) {
		sender.remove_body(_trace.bodies[_removed[i]].id);
	}
	for (size_t i = step.begin; i < step.end; ++i) {
		const SampleIndex &index = _trace.order[i];
		const uint32_t id = _trace.bodies[index.body].id;
		const cga::Pose<double> &pose = _trace.sample(index).pose;
		if (index.sample == 0) {
			sender.add_body(id, pose);
		}
		rejected += !sender.observe(id, step.time, pose);
	}
	sender.flush(step.time);
	return rejected;
}

} // namespace bench
