#include "net/motion/body_state.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

constexpr std::int64_t MOST_SPEED = std::int64_t(1) << 30;
constexpr std::int64_t MOST_BEND = std::int64_t(1) << 28;
constexpr std::int32_t MOST_SCORE = 4000;

double scale_of(std::int32_t level) {
	return level == 0 ? 1.0 : std::exp2(double(level) / BodyState::SCALE_LEVELS);
}

} // namespace

bool BodyState::can_hold(const cga::Pose<double> &pose, const StreamGrid &grid) {
	const double norm = glm::dot(pose.rotation, pose.rotation);
	const double reach = double(MOST_STEPS) * grid.position;
	const cga::Vector3<double> &at = pose.translation;
	// A comparison with what is not a number fails.
	return std::fabs(at.x) < reach && std::fabs(at.y) < reach && std::fabs(at.z) < reach && norm > 1e-12 && norm < 1e12 && pose.scale >= LEAST_SCALE && pose.scale <= 1.0 / LEAST_SCALE;
}

bool BodyState::set_pose(const cga::Pose<double> &pose, const StreamGrid &grid) {
	if (!can_hold(pose, grid)) {
		return false;
	}
	*this = BodyState();
	for (int i = 0; i < 3; ++i) {
		position_[i] = std::int64_t(std::floor(pose.translation[i] / grid.position + 0.5));
	}
	rotation_ = LatticeRotation::nearest(glm::normalize(pose.rotation));
	scale_ = pose.scale == 1.0 ? 0 : std::int32_t(std::round(std::log2(pose.scale) * SCALE_LEVELS));
	return true;
}

cga::Pose<double> BodyState::pose(const StreamGrid &grid) const {
	return { cga::Vector3<double>(double(position_[0]), double(position_[1]), double(position_[2])) * grid.position, rotation_.value(), scale_of(scale_) };
}

void BodyState::rest() {
	std::fill(velocity_, velocity_ + 6, 0);
	std::fill(bend_, bend_ + 6, 0);
	ticks_ = 1;
	for (int group = 0; group < 2; ++group) {
		std::fill(score_[group], score_[group] + PREDICTORS, 0);
		bent_[group] = false;
		end_mean_[group] = MeanMagnitude(512);
		bend_mean_[group] = MeanMagnitude(256);
	}
	scaled_ = false;
	active = false;
}

std::int64_t BodyState::predicted_by(int predictor, int coordinate, int ticks) const {
	const std::int64_t steady = (std::int64_t(velocity_[coordinate]) * ticks + 128) >> 8;
	switch (predictor) {
		case HOLD:
			return 0;
		case ACCELERATED:
			return steady - std::int64_t(bend_[coordinate]) * (ticks * ticks) / (ticks_ * ticks_);
		case DAMPED:
			return steady / 2;
		default:
			return steady;
	}
}

int BodyState::best_predictor(int group) const {
	int best = STEADY;
	for (const int other : { HOLD, ACCELERATED, DAMPED }) {
		if (score_[group][other] < score_[group][best]) {
			best = other;
		}
	}
	return best;
}

std::int64_t BodyState::predicted(int coordinate, int ticks) const {
	return predicted_by(best_predictor(coordinate / 3), coordinate, ticks);
}

SegmentSteps BodyState::steps(const SegmentCode &code) const {
	std::int64_t ends[6];
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
		segment.way[i] = double(steps.way[i]) * grid.position;
		segment.way_bend[i] = double(steps.bend[i]) * grid.position;
		segment.turn[i] = double(steps.way[3 + i]) * grid.rotation;
		segment.turn_bend[i] = double(steps.bend[3 + i]) * grid.rotation;
	}
	if (code.scaled) {
		segment.scale_ratio = scale_of(scale_ + code.scale) / segment.from.scale;
	}
	return segment;
}

bool BodyState::apply(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid) {
	const std::int32_t scale = scale_ + (code.scaled ? code.scale : 0);
	if (scale < -MOST_SCALE || scale > MOST_SCALE) {
		return false;
	}
	double turn = 0.0;
	for (int i = 0; i < 3; ++i) {
		if (std::abs(position_[i] + steps.way[i]) > MOST_STEPS) {
			return false;
		}
		turn += std::fabs(double(steps.way[3 + i]) * grid.rotation);
	}
	if (!(turn < 16.0)) {
		return false;
	}
	for (int group = 0; group < 2; ++group) {
		std::int64_t error[PREDICTORS] = { 0, 0, 0, 0 };
		for (int i = 3 * group; i < 3 * group + 3; ++i) {
			const std::int64_t steady = predicted_by(STEADY, i, code.ticks);
			error[HOLD] += std::abs(steps.way[i]);
			error[STEADY] += std::abs(steps.way[i] - steady);
			error[DAMPED] += std::abs(steps.way[i] - steady / 2);
			error[ACCELERATED] += std::abs(steps.way[i] - predicted_by(ACCELERATED, i, code.ticks));
		}
		for (int predictor = 0; predictor < PREDICTORS; ++predictor) {
			score_[group][predictor] += (std::int32_t(std::min<std::int64_t>(error[predictor], MOST_SCORE)) * 16 - score_[group][predictor]) / 4;
		}
	}
	for (int i = 0; i < 6; ++i) {
		const int group = i / 3;
		end_mean_[group].add(code.fine ? code.end[i] / 2 : code.end[i]);
		if (code.bent[group]) {
			bend_mean_[group].add(code.bend[i]);
		}
		bent_[group] = code.bent[group];
		// Half of the bend's turn of the direction at the end: what it says of the next segment is half noise.
		velocity_[i] = std::int32_t(std::clamp((256 * steps.way[i] - 128 * steps.bend[i]) / code.ticks, -MOST_SPEED, MOST_SPEED));
		bend_[i] = std::int32_t(std::clamp(steps.bend[i], -MOST_BEND, MOST_BEND));
	}
	for (int i = 0; i < 3; ++i) {
		position_[i] += steps.way[i];
	}
	const cga::Vector3<double> vector(double(steps.way[3]), double(steps.way[4]), double(steps.way[5]));
	rotation_ = LatticeRotation::nearest(rotation_.value() * exp_rotation(vector * grid.rotation));
	ticks_ = code.ticks;
	scale_ = scale;
	scaled_ = code.scaled;
	active = true;
	settled = false;
	return true;
}

bool BodyState::settle(const std::int32_t offset[6], const StreamGrid &grid) {
	for (int i = 0; i < 3; ++i) {
		if (std::abs(position_[i] + offset[i]) > MOST_STEPS || std::abs(offset[3 + i]) > MeanMagnitude::MOST) {
			return false;
		}
	}
	for (int i = 0; i < 3; ++i) {
		position_[i] += offset[i];
	}
	const cga::Vector3<double> vector(offset[3], offset[4], offset[5]);
	rotation_ = LatticeRotation::nearest(rotation_.value() * exp_rotation(vector * grid.rotation));
	settled = true;
	return true;
}

bool BodyState::is_valid() const {
	for (const std::int64_t value : position_) {
		if (std::abs(value) > MOST_STEPS) {
			return false;
		}
	}
	for (int i = 0; i < 6; ++i) {
		if (std::abs(std::int64_t(velocity_[i])) > MOST_SPEED || std::abs(std::int64_t(bend_[i])) > MOST_BEND) {
			return false;
		}
	}
	for (int group = 0; group < 2; ++group) {
		for (const MeanMagnitude &mean : { end_mean_[group], bend_mean_[group] }) {
			if (mean.value() < 0 || mean.value() > MeanMagnitude::MOST * 256) {
				return false;
			}
		}
	}
	return rotation_.is_valid() && std::abs(scale_) <= MOST_SCALE && ticks_ >= 1 && ticks_ <= 64;
}

std::uint32_t BodyState::hash() const {
	std::uint64_t mixed = std::uint64_t(scale_) + 0x9e3779b97f4a7c15u;
	for (int i = 0; i < 3; ++i) {
		mixed = (mixed ^ std::uint64_t(position_[i])) * 0xff51afd7ed558ccdu;
		mixed = (mixed ^ std::uint64_t(std::uint32_t(rotation_.level[i])) ^ (mixed >> 29)) * 0xc4ceb9fe1a85ec53u;
	}
	return std::uint32_t(mixed >> 32);
}

} // namespace net
