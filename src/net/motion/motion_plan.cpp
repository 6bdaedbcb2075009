#include "net/motion/motion_plan.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// Shares of the tolerance within which a body that moved comes to rest, and one that rests stays so.
constexpr double COMES_TO_REST = 0.6;
constexpr double STAYS_AT_REST = 0.9;
/// A body whose samples are nearer together than this does not move: it rests wherever the tolerance let it end (with a
/// per cent for rounding), and settles.
constexpr double STILL = 0.1;
constexpr double STOPPED = 1.01;

/// Ticks within which times are the same.
constexpr double SAME_TIME = 1e-6;

size_t count_until(const MotionSample *samples, size_t count, double end) {
	size_t n = 0;
	while (n < count && samples[n].time <= end + SAME_TIME) {
		++n;
	}
	return n;
}

} // namespace

bool MotionPlanner::plan(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion) {
	motion.active = false;
	motion.settles = false;
	motion.count = 0;
	if (count == 0) {
		return true;
	}
	const double most = StreamGrid::TOLERANCE * _grid.position;
	const cga::Pose<double> &last = samples[count - 1].pose;
	const bool has_stopped = !(state.settled && !state.active) && std::all_of(samples, samples + count, [&](const MotionSample &sample) { return pose_distance(sample.pose, last, _grid.lever_arm) <= STILL * most; });
	const double tolerance = most * (has_stopped ? STOPPED : (state.active ? COMES_TO_REST : STAYS_AT_REST));
	const cga::Pose<double> held = state.pose(_grid);
	for (size_t i = count; i > 0; --i) {
		if (pose_distance(held, samples[i - 1].pose, _grid.lever_arm) > tolerance) {
			motion.active = true;
			return plan_moving(state, begin, ticks, samples, count, available, models, motion);
		}
	}
	plan_resting(state, samples[count - 1], motion);
	return true;
}

void MotionPlanner::plan_resting(const BodyState &state, const MotionSample &last, MotionCode &motion) const {
	if (state.active || state.settled) {
		return;
	}
	const cga::Pose<double> held = state.pose(_grid);
	const cga::Vector3<double> displacement = (last.pose.translation - held.translation) / _grid.position;
	const cga::Vector3<double> turn = log_rotation(glm::conjugate(held.rotation) * last.pose.rotation) / _grid.rotation;
	for (int i = 0; i < 3; ++i) {
		motion.offset[i] = int32_t(std::clamp(std::nearbyint(displacement[i]), -16.0, 15.0));
		motion.offset[3 + i] = int32_t(std::clamp(std::nearbyint(turn[i]), -16.0, 15.0));
	}
	motion.settles = true;
}

bool MotionPlanner::plan_moving(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion) {
	BodyState moving = state;
	while (ticks > 0) {
		SegmentFit::Result result;
		_fit.begin(moving, begin, samples, count, available);
		if (!_fit.fit(moving, ticks, count, true, models, result) && !longest_segment(moving, begin, ticks, samples, count, models, result)) {
			return false;
		}
		if (!moving.apply(result.code, moving.steps(result.code), _grid)) {
			return false;
		}
		motion.segments[size_t(motion.count++)] = result.code;
		begin += result.code.ticks;
		ticks -= result.code.ticks;
		const size_t passed = count_until(samples, count, begin);
		samples += passed;
		count -= passed;
		available -= passed;
	}
	return true;
}

bool MotionPlanner::longest_segment(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, MotionModels &models, SegmentFit::Result &result) {
	// At least up to the first sample; then halving: what fits over some ticks mostly fits over fewer.
	const int least = std::max(1, int(std::ceil(samples[0].time - begin - SAME_TIME)));
	int fits = least - 1;
	for (int most = ticks; most - fits > 1;) {
		const int length = (fits + most) / 2;
		SegmentFit::Result other;
		if (_fit.fit(state, length, count_until(samples, count, begin + length), false, models, other)) {
			fits = length;
			result = other;
		} else {
			most = length;
		}
	}
	if (fits >= least) {
		SegmentFit::Result better;
		if (_fit.fit(state, fits, count_until(samples, count, begin + fits), true, models, better)) {
			result = better;
		}
		return true;
	}
	const size_t first = count_until(samples, count, begin + least);
	return _fit.reach(state, least, first - 1, result);
}

} // namespace net
