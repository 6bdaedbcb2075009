#include "net/motion/motion_plan.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// Fractions of the tolerance within which a moving body comes to rest and a resting body stays at rest.
constexpr double COMES_TO_REST = 0.6;
constexpr double STAYS_AT_REST = 0.9;
/// A body has stopped if its samples differ by at most this fraction of the tolerance. It comes to rest once it is within the
/// tolerance (and 1 % for rounding), and a rest correction follows.
constexpr double MAX_STOPPED_MOTION = 0.1;
constexpr double STOPPED = 1.01;

/// Times that differ by less, in ticks, are the same.
constexpr double SAME_TIME = 1e-6;

size_t count_until(const MotionSample *samples, size_t count, double end) {
	size_t n = 0;
	while (n < count && samples[n].time <= end + SAME_TIME) {
		++n;
	}
	return n;
}

} // namespace

void MotionPlanner::plan(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion) {
	motion.active = false;
	motion.has_rest_correction = false;
	motion.must_jump = false;
	motion.count = 0;
	if (count == 0) {
		return;
	}
	const double full_tolerance = StreamGrid::TOLERANCE * _grid.position_step;
	const cga::Pose<double> &last = samples[count - 1].pose;
	const bool has_stopped = (state.active || !state.rest_corrected) && std::all_of(samples, samples + count, [&](const MotionSample &sample) { return pose_distance(sample.pose, last, _grid.lever_arm) <= MAX_STOPPED_MOTION * full_tolerance; });
	BodyState relaxed = state;
	relaxed.set_coarseness(motion.coarseness, motion.finer);
	const double tolerance = full_tolerance * (has_stopped ? STOPPED * (1 << state.coarseness) : (state.active ? COMES_TO_REST : STAYS_AT_REST * (1 << relaxed.coarseness)));
	const cga::Pose<double> held = state.pose(_grid);
	for (size_t i = count; i > 0; --i) {
		if (pose_distance(held, samples[i - 1].pose, _grid.lever_arm) > tolerance) {
			plan_moving(relaxed, begin, ticks, samples, count, available, models, motion);
			return;
		}
	}
	plan_resting(state, samples[count - 1], motion);
}

void MotionPlanner::plan_resting(const BodyState &state, const MotionSample &last, MotionCode &motion) const {
	if (state.active || state.rest_corrected) {
		return;
	}
	const cga::Pose<double> held = state.pose(_grid);
	const cga::Vector3<double> translation = (last.pose.translation - held.translation) / _grid.position_step;
	const cga::Vector3<double> rotation = log_rotation(glm::conjugate(held.rotation) * last.pose.rotation) / _grid.rotation_step;
	const double limit = double(1 << (MotionCode::REST_BITS - 1 + state.coarseness));
	for (int i = 0; i < 3; ++i) {
		motion.rest_correction[i] = int32_t(std::clamp(std::nearbyint(translation[i]), -limit, limit - 1.0));
		motion.rest_correction[3 + i] = int32_t(std::clamp(std::nearbyint(rotation[i]), -limit, limit - 1.0));
	}
	motion.has_rest_correction = true;
}

void MotionPlanner::plan_moving(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion) {
	BodyState moving = state;
	while (ticks > 0) {
		_fit.begin(moving, begin, samples, count, available);
		std::optional<SegmentCode> code = _fit.fit(moving, ticks, count, true, models);
		if (!code) {
			code = longest_segment(moving, begin, ticks, samples, count, models);
		}
		if (!code || !moving.apply(*code, moving.steps(*code), _grid)) {
			motion.must_jump = true;
			return;
		}
		motion.segments[size_t(motion.count++)] = *code;
		begin += code->ticks;
		ticks -= code->ticks;
		const size_t passed = count_until(samples, count, begin);
		samples += passed;
		count -= passed;
		available -= passed;
	}
	motion.active = true;
}

std::optional<SegmentCode> MotionPlanner::longest_segment(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, MotionModels &models) {
	// Bisect between the first sample and the end: if a curve fits over some length, one usually fits over a shorter length.
	const int min_ticks = std::max(1, int(std::ceil(samples[0].time - begin - SAME_TIME)));
	std::optional<SegmentCode> longest;
	int fitting = min_ticks - 1;
	for (int too_long = ticks; too_long - fitting > 1;) {
		const int length = (fitting + too_long) / 2;
		if (const auto code = _fit.fit(state, length, count_until(samples, count, begin + length), false, models)) {
			fitting = length;
			longest = code;
		} else {
			too_long = length;
		}
	}
	if (longest) {
		const auto cheaper = _fit.fit(state, fitting, count_until(samples, count, begin + fitting), true, models);
		return cheaper ? cheaper : longest;
	}
	const size_t first = count_until(samples, count, begin + min_ticks);
	return _fit.reach(state, min_ticks, first - 1);
}

} // namespace net
