#include "net/motion/body_state.hpp"

#include "net/coding/portable_math.hpp"
#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace net {

namespace {

constexpr int64_t MAX_SPEED = int64_t(1) << 30;
constexpr int64_t MAX_CURVATURE = int64_t(1) << 28;
constexpr int64_t MAX_RUNNING_ERROR = 4000;
constexpr int32_t MAX_REST_CORRECTION = 16 << BodyState::MAX_COARSENESS;
constexpr double MAX_ANGLE = 16.0; // of a segment, in radians, as the sum of three components

double scale_of(int32_t level) {
	return level == 0 ? 1.0 : portable_exp2(double(level) / BodyState::SCALE_LEVELS);
}

} // namespace

bool BodyState::is_in_range(const cga::Pose<double> &pose, const StreamGrid &grid) {
	const double norm = glm::dot(pose.rotation, pose.rotation);
	const double max_distance = double(MAX_STEPS) * grid.position_step;
	const cga::Vector3<double> &position = pose.translation;
	// Comparisons with NaN fail.
	return std::fabs(position.x) < max_distance && std::fabs(position.y) < max_distance && std::fabs(position.z) < max_distance && norm > 1e-12 && norm < 1e12 && pose.scale >= MIN_SCALE && pose.scale <= 1.0 / MIN_SCALE;
}

bool BodyState::set_pose(const cga::Pose<double> &pose, const StreamGrid &grid) {
	if (!is_in_range(pose, grid)) {
		return false;
	}
	BodyState at_rest;
	at_rest.planar = planar;
	*this = at_rest;
	for (int i = 0; i < 3; ++i) {
		_position[i] = int64_t(std::floor(pose.translation[i] / grid.position_step + 0.5));
	}
	_rotation = LatticeRotation::nearest(glm::normalize(pose.rotation));
	_scale = pose.scale == 1.0 ? 0 : int32_t(std::round(portable_log2(pose.scale) * SCALE_LEVELS));
	return true;
}

cga::Pose<double> BodyState::pose(const StreamGrid &grid) const {
	return { cga::Vector3<double>(double(_position[0]), double(_position[1]), double(_position[2])) * grid.position_step, _rotation.value(), scale_of(_scale) };
}

void BodyState::reset_motion() {
	BodyState at_rest;
	std::copy_n(_position, 3, at_rest._position);
	at_rest._rotation = _rotation;
	at_rest._scale = _scale;
	at_rest.planar = planar;
	at_rest.rest_corrected = rest_corrected;
	at_rest.coarseness = coarseness;
	*this = at_rest;
}

int64_t BodyState::predicted_by(int predictor, int coordinate, int ticks) const {
	const int64_t linear = (int64_t(_velocity[coordinate]) * ticks + 128) >> 8;
	switch (predictor) {
		case HOLD:
			return 0;
		case CONSTANT_ACCELERATION:
			// Most curvatures are zero, and the division is slow.
			return _curvature[coordinate] == 0 ? linear : linear - int64_t(_curvature[coordinate]) * ticks * ticks / (int64_t(_ticks) * _ticks);
		case DAMPED:
			return linear / 2;
		default:
			return linear;
	}
}

int BodyState::best_predictor(int group) const {
	int best = CONSTANT_VELOCITY;
	for (const int other : { HOLD, CONSTANT_ACCELERATION, DAMPED }) {
		if (_running_error[group][other] < _running_error[group][best]) {
			best = other;
		}
	}
	return best;
}

SegmentSteps BodyState::steps(const SegmentCode &code) const {
	int64_t ends[6];
	for (int i = 0; i < 6; ++i) {
		ends[i] = predicted(i, code.ticks);
	}
	return SegmentSteps(ends, code, coarseness);
}

MotionSegment BodyState::segment(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid, double begin, cga::Mode mode) const {
	MotionSegment segment;
	segment.begin = begin;
	segment.length = code.ticks;
	segment.start = pose(grid);
	segment.mode = mode;
	for (int i = 0; i < 3; ++i) {
		segment.displacement[i] = double(steps.end[i]) * grid.position_step;
		segment.translation_curvature[i] = double(steps.curvature[i]) * grid.position_step;
		segment.rotation[i] = double(steps.end[3 + i]) * grid.rotation_step;
		segment.rotation_curvature[i] = double(steps.curvature[3 + i]) * grid.rotation_step;
	}
	if (code.scaled) {
		segment.scale_ratio = scale_of(_scale + code.scale_change) / segment.start.scale;
	}
	return segment;
}

bool BodyState::apply(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid) {
	const int32_t scale = _scale + (code.scaled ? code.scale_change : 0);
	if (scale < -MAX_SCALE || scale > MAX_SCALE) {
		return false;
	}
	double angle = 0.0;
	for (int i = 0; i < 3; ++i) {
		if (std::abs(_position[i] + steps.end[i]) > MAX_STEPS) {
			return false;
		}
		angle += std::fabs(double(steps.end[3 + i]) * grid.rotation_step);
	}
	if (!(angle < MAX_ANGLE)) {
		return false;
	}
	for (int group = 0; group < 2; ++group) {
		for (int predictor = 0; predictor < PREDICTOR_COUNT; ++predictor) {
			int64_t error = 0;
			for (int i = 3 * group; i < 3 * group + 3; ++i) {
				error += std::abs(steps.end[i] - predicted_by(predictor, i, code.ticks));
			}
			int32_t &running = _running_error[group][predictor];
			running += (int32_t(std::min(error, MAX_RUNNING_ERROR)) * 16 - running) / 4;
		}
	}
	for (int i = 0; i < 6; ++i) {
		if (!is_coded(i)) {
			continue;
		}
		const int group = i / 3;
		_residual_mean[group].add(code.fine ? code.residual[i] / 2 : code.residual[i]);
		if (code.curved[group]) {
			_curvature_mean[group].add(code.curvature[i]);
		}
		_curved[group] = code.curved[group];
		// The velocity at the end is (end - curvature) / ticks. Half of the curvature predicts better, as the rest is noise.
		_velocity[i] = int32_t(std::clamp((256 * steps.end[i] - 128 * steps.curvature[i]) / code.ticks, -MAX_SPEED, MAX_SPEED));
		_curvature[i] = int32_t(std::clamp(steps.curvature[i], -MAX_CURVATURE, MAX_CURVATURE));
	}
	for (int i = 0; i < 3; ++i) {
		_position[i] += steps.end[i];
	}
	const cga::Vector3<double> vector(double(steps.end[3]), double(steps.end[4]), double(steps.end[5]));
	_rotation = LatticeRotation::nearest(_rotation.value() * exp_rotation(vector * grid.rotation_step));
	_ticks = code.ticks;
	_scale = scale;
	_scaled = code.scaled;
	active = true;
	rest_corrected = false;
	return true;
}

bool BodyState::correct_rest(const int32_t correction[6], const StreamGrid &grid) {
	for (int i = 0; i < 3; ++i) {
		if (std::abs(_position[i] + correction[i]) > MAX_STEPS || std::abs(correction[3 + i]) > MAX_REST_CORRECTION) {
			return false;
		}
	}
	for (int i = 0; i < 3; ++i) {
		_position[i] += correction[i];
	}
	const cga::Vector3<double> vector(correction[3], correction[4], correction[5]);
	_rotation = LatticeRotation::nearest(_rotation.value() * exp_rotation(vector * grid.rotation_step));
	rest_corrected = true;
	coarseness = 0;
	return true;
}

bool BodyState::is_valid() const {
	const auto are_within = [](const auto &values, int64_t max) {
		return std::all_of(std::begin(values), std::end(values), [max](int64_t value) { return std::abs(value) <= max; });
	};
	const auto are_means = [](const MeanMagnitude(&means)[2]) {
		return std::all_of(means, means + 2, [](const MeanMagnitude &mean) { return mean.value() >= 0 && mean.value() <= MeanMagnitude::MAX * 256; });
	};
	const bool is_in_plane = _position[2] == 0 && _rotation.dropped >= 2 && _rotation.level[0] == 0 && _rotation.level[1] == 0;
	return (!planar || is_in_plane) && are_within(_position, MAX_STEPS) && are_within(_velocity, MAX_SPEED) && are_within(_curvature, MAX_CURVATURE) && are_means(_residual_mean) && are_means(_curvature_mean) &&
			_rotation.is_valid() && std::abs(_scale) <= MAX_SCALE && coarseness <= MAX_COARSENESS && finer <= MAX_COARSENESS && _ticks >= 1 && _ticks <= 64;
}

uint32_t BodyState::hash() const {
	uint64_t mixed = uint64_t(_scale) + 0x9e3779b97f4a7c15u;
	for (int i = 0; i < 3; ++i) {
		mixed = (mixed ^ uint64_t(_position[i])) * 0xff51afd7ed558ccdu;
		mixed = (mixed ^ uint64_t(uint32_t(_rotation.level[i])) ^ (mixed >> 29)) * 0xc4ceb9fe1a85ec53u;
	}
	return uint32_t(mixed >> 32);
}

} // namespace net
