#include "cga/batch/pose_block.hpp"

#include "cga/batch/lane_access.hpp"
#include "cga/motor/axis_angle.hpp"
#include "cga/motor/pose_motion.hpp"
#include "cga/motor/similarity_phi.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace cga {

namespace {

// A shift that the kernels can still multiply and add within float's range.
float bounded(double shift) {
	constexpr double LIMIT = double(std::numeric_limits<float>::max()) / 16.0;
	return float(std::clamp(shift, -LIMIT, LIMIT));
}

Vector3<float> bounded(const Vector3<double> &shift) {
	return { bounded(shift.x), bounded(shift.y), bounded(shift.z) };
}

// Turns to_rotation to the hemisphere 1 or -1.
void set_hemisphere(PoseBlock &block, int lane, float hemisphere) {
	for (PoseBlock::Row &row : block.to_rotation) {
		row[lane] *= block.hemisphere[lane] * hemisphere;
	}
	block.hemisphere[lane] = hemisphere;
}

// 1 / (exp(z) - 1), or the factor of a plain weight where z is too small for float to tell the two apart.
struct PowerFactor {
	std::complex<double> factor{ 0.0 };
	double linear = 0.0;
};

PowerFactor power_factor(const std::complex<double> &z) {
	constexpr double SMALL = 1e-7;
	if (std::abs(z) < SMALL) {
		return { 0.0, 1.0 };
	}
	return { 1.0 / (z * phi(z)), 0.0 };
}

// Everything that depends on both poses.
void prepare(PoseBlock &block, int lane) {
	const Pose<double> from = pose_cast<double>(block.get_from(lane));
	const Pose<double> to = pose_cast<double>(block.get_to(lane));
	const PoseMotion motion = motion_between(from, to);
	const Vector3<double> turn_vector = vector_part(motion.turn);
	store_lane(block.shift, lane, bounded(motion.shift));
	block.shrinking[lane] = float(2.0 - 2.0 * motion.turn.w);
	store_lane(block.bend, lane, bounded(motion.shift * motion.turn.w + glm::cross(motion.shift, turn_vector)));
	set_hemisphere(block, lane, float(motion.hemisphere));

	const double sine = detail::length(turn_vector);
	const double half_angle = sine > 0.0 ? std::atan2(sine, motion.turn.w) : 0.0;
	block.half_angle[lane] = float(half_angle);
	store_lane(block.axis, lane, sine > 0.0 ? Vector3<float>(turn_vector / sine) : Vector3<float>(0.0f));

	const bool positive = from.scale > 0.0 && to.scale > 0.0;
	const double log_scale = positive ? std::log(to.scale / from.scale) : 0.0;
	block.log_scale[lane] = float(log_scale);
	block.scale_change[lane] = positive ? 0.0f : bounded(to.scale - from.scale);

	const PowerFactor across = power_factor({ log_scale, 2.0 * half_angle });
	block.across[0][lane] = float(across.factor.real());
	block.across[1][lane] = float(across.factor.imag());
	block.across_linear[lane] = float(across.linear);
	const PowerFactor along = power_factor(log_scale);
	block.along[lane] = float(along.factor.real());
	block.along_linear[lane] = float(along.linear);
}

void store_from(PoseBlock &block, int lane, const Pose<float> &from) {
	store_lane(block.from_rotation, lane, unit_rotation(from.rotation));
	store_lane(block.from_translation, lane, from.translation);
	block.from_scale[lane] = from.scale;
}

void store_to(PoseBlock &block, int lane, const Pose<float> &to) {
	store_lane(block.to_rotation, lane, unit_rotation(to.rotation));
	block.hemisphere[lane] = 1.0f;
	store_lane(block.to_translation, lane, to.translation);
	block.to_scale[lane] = to.scale;
}

} // namespace

PoseBlock::PoseBlock() noexcept {
	for (int lane = 0; lane < LANES; ++lane) {
		set(lane, Pose<float>(), Pose<float>());
	}
}

void PoseBlock::set(int lane, const Pose<float> &from, const Pose<float> &to) noexcept {
	store_from(*this, lane, from);
	store_to(*this, lane, to);
	prepare(*this, lane);
}

void PoseBlock::set_from(int lane, const Pose<float> &from) noexcept {
	store_from(*this, lane, from);
	prepare(*this, lane);
}

void PoseBlock::set_to(int lane, const Pose<float> &to) noexcept {
	store_to(*this, lane, to);
	prepare(*this, lane);
}

Pose<float> PoseBlock::get_from(int lane) const noexcept {
	return { load_lane(from_translation, lane), load_lane(from_rotation, lane), from_scale[lane] };
}

Pose<float> PoseBlock::get_to(int lane) const noexcept {
	return { load_lane(to_translation, lane), load_lane(to_rotation, lane) * hemisphere[lane], to_scale[lane] };
}

} // namespace cga
