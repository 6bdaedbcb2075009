#include "net/motion/body_state.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

constexpr int64_t MAX_SPEED = int64_t(1) << 30;
constexpr int64_t MAX_CURVATURE = int64_t(1) << 28;
constexpr int32_t MAX_SCORE = 4000;

double scale_of(int32_t level) {
	return level == 0 ? 1.0 : std::exp2(double(level) / BodyState::SCALE_LEVELS);
}

} // namespace

bool BodyState::can_hold(const cga::Pose<double> &pose, const StreamGrid &grid) {
	const double norm = glm::dot(pose.rotation, pose.rotation);
	const double reach = double(MAX_STEPS) * grid.position;
	const cga::Vector3<double> &at = pose.translation;
	// A comparison with what is not a number fails.
	return std::fabs(at.x) < reach && std::fabs(at.y) < reach && std::fabs(at.z) < reach && norm > 1e-12 && norm < 1e12 && pose.scale >= MIN_SCALE && pose.scale <= 1.0 / MIN_SCALE;
}

bool BodyState::set_pose(const cga::Pose<double> &pose, const StreamGrid &grid) {
	if (!can_hold(pose, grid)) {
		return false;
	}
	*this = BodyState();
	for (int i = 0; i < 3; ++i) {
		_position[i] = int64_t(std::floor(pose.translation[i] / grid.position + 0.5));
	}
	_rotation = LatticeRotation::nearest(glm::normalize(pose.rotation));
	_scale = pose.scale == 1.0 ? 0 : int32_t(std::round(std::log2(pose.scale) * SCALE_LEVELS));
	return true;
}

cga::Pose<double> BodyState::pose(const StreamGrid &grid) const {
	return { cga::Vector3<double>(double(_position[0]), double(_position[1]), double(_position[2])) * grid.position, _rotation.value(), scale_of(_scale) };
}

void BodyState::rest() {
	std::fill(_velocity, _velocity + 6, 0);
	std::fill(_curvature, _curvature + 6, 0);
	_ticks = 1;
	for (int group = 0; group < 2; ++group) {
		std::fill(_score[group], _score[group] + PREDICTORS, 0);
		_curved[group] = false;
		_end_mean[group] = MeanMagnitude(512);
		_curvature_mean[group] = MeanMagnitude(256);
	}
	_scaled = false;
	active = false;
}

int64_t BodyState::predicted_by(int predictor, int coordinate, int ticks) const {
	const int64_t steady = (int64_t(_velocity[coordinate]) * ticks + 128) >> 8;
	switch (predictor) {
		case HOLD:
			return 0;
		case ACCELERATED:
			return steady - int64_t(_curvature[coordinate]) * (ticks * ticks) / (_ticks * _ticks);
		case DAMPED:
			return steady / 2;
		default:
			return steady;
	}
}

int BodyState::best_predictor(int group) const {
	int best = STEADY;
	for (const int other : { HOLD, ACCELERATED, DAMPED }) {
		if (_score[group][other] < _score[group][best]) {
			best = other;
		}
	}
	return best;
}

int64_t BodyState::predicted(int coordinate, int ticks) const {
	return predicted_by(best_predictor(coordinate / 3), coordinate, ticks);
}

SegmentSteps BodyState::steps(const SegmentCode &code) const {
	int64_t ends[6];
	for (int i = 0; i < 6; ++i) {
		ends[i] = predicted(i, code.ticks);
	}
	return SegmentSteps(ends, code);
}

MotionSegment BodyState::segment(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid, double begin, cga::Mode mode) const {
	MotionSegment segment;
	segment.begin = begin;
	segment.length = code.ticks;
	segment.from = pose(grid);
	segment.mode = mode;
	for (int i = 0; i < 3; ++i) {
		segment.displacement[i] = double(steps.displacement[i]) * grid.position;
		segment.translation_curvature[i] = double(steps.curvature[i]) * grid.position;
		segment.turn[i] = double(steps.displacement[3 + i]) * grid.rotation;
		segment.rotation_curvature[i] = double(steps.curvature[3 + i]) * grid.rotation;
	}
	if (code.scaled) {
		segment.scale_ratio = scale_of(_scale + code.scale) / segment.from.scale;
	}
	return segment;
}

bool BodyState::apply(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid) {
	const int32_t scale = _scale + (code.scaled ? code.scale : 0);
	if (scale < -MAX_SCALE || scale > MAX_SCALE) {
		return false;
	}
	double turn = 0.0;
	for (int i = 0; i < 3; ++i) {
		if (std::abs(_position[i] + steps.displacement[i]) > MAX_STEPS) {
			return false;
		}
		turn += std::fabs(double(steps.displacement[3 + i]) * grid.rotation);
	}
	if (!(turn < 16.0)) {
		return false;
	}
	for (int group = 0; group < 2; ++group) {
		int64_t error[PREDICTORS] = { 0, 0, 0, 0 };
		for (int i = 3 * group; i < 3 * group + 3; ++i) {
			const int64_t steady = predicted_by(STEADY, i, code.ticks);
			error[HOLD] += std::abs(steps.displacement[i]);
			error[STEADY] += std::abs(steps.displacement[i] - steady);
			error[DAMPED] += std::abs(steps.displacement[i] - steady / 2);
			error[ACCELERATED] += std::abs(steps.displacement[i] - predicted_by(ACCELERATED, i, code.ticks));
		}
		for (int predictor = 0; predictor < PREDICTORS; ++predictor) {
			_score[group][predictor] += (int32_t(std::min<int64_t>(error[predictor], MAX_SCORE)) * 16 - _score[group][predictor]) / 4;
		}
	}
	for (int i = 0; i < 6; ++i) {
		const int group = i / 3;
		_end_mean[group].add(code.fine ? code.end[i] / 2 : code.end[i]);
		if (code.curved[group]) {
			_curvature_mean[group].add(code.curvature[i]);
		}
		_curved[group] = code.curved[group];
		// Half of the bend's turn of the direction at the end: what it says of the next segment is half noise.
		_velocity[i] = int32_t(std::clamp((256 * steps.displacement[i] - 128 * steps.curvature[i]) / code.ticks, -MAX_SPEED, MAX_SPEED));
		_curvature[i] = int32_t(std::clamp(steps.curvature[i], -MAX_CURVATURE, MAX_CURVATURE));
	}
	for (int i = 0; i < 3; ++i) {
		_position[i] += steps.displacement[i];
	}
	const cga::Vector3<double> vector(double(steps.displacement[3]), double(steps.displacement[4]), double(steps.displacement[5]));
	_rotation = LatticeRotation::nearest(_rotation.value() * exp_rotation(vector * grid.rotation));
	_ticks = code.ticks;
	_scale = scale;
	_scaled = code.scaled;
	active = true;
	settled = false;
	return true;
}

bool BodyState::settle(const int32_t offset[6], const StreamGrid &grid) {
	for (int i = 0; i < 3; ++i) {
		if (std::abs(_position[i] + offset[i]) > MAX_STEPS || std::abs(offset[3 + i]) > MeanMagnitude::MAX) {
			return false;
		}
	}
	for (int i = 0; i < 3; ++i) {
		_position[i] += offset[i];
	}
	const cga::Vector3<double> vector(offset[3], offset[4], offset[5]);
	_rotation = LatticeRotation::nearest(_rotation.value() * exp_rotation(vector * grid.rotation));
	settled = true;
	return true;
}

bool BodyState::is_valid() const {
	for (const int64_t value : _position) {
		if (std::abs(value) > MAX_STEPS) {
			return false;
		}
	}
	for (int i = 0; i < 6; ++i) {
		if (std::abs(int64_t(_velocity[i])) > MAX_SPEED || std::abs(int64_t(_curvature[i])) > MAX_CURVATURE) {
			return false;
		}
	}
	for (int group = 0; group < 2; ++group) {
		for (const MeanMagnitude &mean : { _end_mean[group], _curvature_mean[group] }) {
			if (mean.value() < 0 || mean.value() > MeanMagnitude::MAX * 256) {
				return false;
			}
		}
	}
	return _rotation.is_valid() && std::abs(_scale) <= MAX_SCALE && _ticks >= 1 && _ticks <= 64;
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
