#include "cga/batch/pose_block.hpp"

#include "cga/batch/lane_access.hpp"
#include "cga/motor/axis_angle.hpp"
#include "cga/motor/matrix_pose.hpp"
#include "cga/motor/pose_motion.hpp"
#include "cga/motor/similarity_phi.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace cga {

namespace {

using kernel::store_lane;

// Clamps a displacement so that the kernels can multiply and add it within the range of float.
float bounded(double displacement) {
	constexpr double LIMIT = double(std::numeric_limits<float>::max()) / 16.0;
	return float(std::clamp(displacement, -LIMIT, LIMIT));
}

Vector3<float> bounded(const Vector3<double> &displacement) {
	return { bounded(displacement.x), bounded(displacement.y), bounded(displacement.z) };
}

// Negates to_rotation if it is not in the given hemisphere, 1 or -1.
void set_hemisphere(PoseBlock &block, int lane, float hemisphere) {
	for (PoseBlock::Row &row : block.to_rotation) {
		row[lane] *= block.hemisphere[lane] * hemisphere;
	}
	block.hemisphere[lane] = hemisphere;
}

// (exp(a z) - 1) / (exp(z) - 1) = factor (exp(a z) - 1) + linear a. For tiny z, it is the weight a within the rounding of float.
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

// Computes everything that depends on both poses.
void prepare(PoseBlock &block, int lane) {
	const Pose<double> from = pose_cast<double>(block.get_from(lane));
	const Pose<double> to = pose_cast<double>(block.get_to(lane));
	const PoseMotion motion = motion_between(from, to);
	const Vector3<double> rotation_vector_part = vector_part(motion.rotation);
	store_lane(block.displacement, lane, bounded(motion.displacement));
	block.shortening[lane] = float(2.0 - 2.0 * motion.rotation.w);
	store_lane(block.curvature, lane, bounded(motion.displacement * motion.rotation.w + glm::cross(motion.displacement, rotation_vector_part)));
	set_hemisphere(block, lane, float(motion.hemisphere));

	const double sine = detail::length(rotation_vector_part);
	const double half_angle = sine > 0.0 ? std::atan2(sine, motion.rotation.w) : 0.0;
	block.half_angle[lane] = float(half_angle);
	store_lane(block.axis, lane, sine > 0.0 ? Vector3<float>(rotation_vector_part / sine) : Vector3<float>(0.0f));

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
	return { kernel::load_lane<Vector3<float>>(from_translation, lane), kernel::load_lane<Quaternion<float>>(from_rotation, lane), from_scale[lane] };
}

Pose<float> PoseBlock::get_to(int lane) const noexcept {
	return { kernel::load_lane<Vector3<float>>(to_translation, lane), kernel::load_lane<Quaternion<float>>(to_rotation, lane) * hemisphere[lane], to_scale[lane] };
}

void pose_to_row(const Pose<float> &pose, float *row) noexcept {
	const glm::dmat3 linear = linear_of_pose(pose_cast<double>(pose));
	for (int i = 0; i < 3; ++i) {
		for (int column = 0; column < 3; ++column) {
			row[4 * i + column] = float(linear[column][i]);
		}
		row[4 * i + 3] = pose.translation[i];
	}
}

Pose<float> pose_from_row(const float *row) noexcept {
	glm::dmat3 linear;
	for (int i = 0; i < 3; ++i) {
		for (int column = 0; column < 3; ++column) {
			linear[column][i] = row[4 * i + column];
		}
	}
	const Vector3<double> translation(row[3], row[7], row[11]);
	if (const Result<Pose<double>, MatrixError> pose = matrix_to_pose(linear, translation)) {
		return pose_cast<float>(*pose);
	}
	Pose<float> moved;
	moved.translation = Vector3<float>(translation);
	return moved;
}

} // namespace cga
