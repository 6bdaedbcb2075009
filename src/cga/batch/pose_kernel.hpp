#pragma once

#include "cga/batch/float_math.hpp"
#include "cga/batch/row_columns.hpp"

#include <limits>

// The kernels of pose pairs, for one lane; a loop of fixed length over the 8 lanes of a block vectorizes them. kernels.inl
// inlines them into functions for each instruction set.

namespace cga::kernel {

namespace {

// An interpolated pose, from which the basis and the origin are computed.
struct LanePose {
	float w, x, y, z; // the rotation; its length is 1 / sqrt(inverse_square)
	float inverse_square;
	float displacement_x, displacement_y, displacement_z; // relative to the position of `from`
	float scale;
};

// q = (1 - a) q_from + a q_to,  |q|^2 = (1 - a)^2 + a^2 + 2 a (1 - a) r_w = 1 - a (1 - a) (2 - 2 r_w)
// t = a (a d + (1 - a) e) / |q|^2     (d the displacement, e = r_w d + d x r_v the curvature)
// and the scale separately: interpolate_linear() in interpolate.cpp, with A q_from = q.
CGA_ALWAYS_INLINE LanePose linear_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float rest = 1.0f - a;
	LanePose pose;
	pose.scale = rest * block.from_scale[lane] + a * block.to_scale[lane];
	pose.w = rest * block.from_rotation[0][lane] + a * block.to_rotation[0][lane];
	pose.x = rest * block.from_rotation[1][lane] + a * block.to_rotation[1][lane];
	pose.y = rest * block.from_rotation[2][lane] + a * block.to_rotation[2][lane];
	pose.z = rest * block.from_rotation[3][lane] + a * block.to_rotation[3][lane];
	pose.inverse_square = 1.0f / (1.0f - (a * rest) * block.shortening[lane]);
	const float factor = a * pose.inverse_square;
	const float straight = factor * a;
	const float bent = factor * rest;
	pose.displacement_x = straight * block.displacement[0][lane] + bent * block.curvature[0][lane];
	pose.displacement_y = straight * block.displacement[1][lane] + bent * block.curvature[1][lane];
	pose.displacement_z = straight * block.displacement[2][lane] + bent * block.curvature[2][lane];
	return pose;
}

// q = A q_from, of unit length.
CGA_ALWAYS_INLINE void set_rotation(LanePose &pose, const PoseBlock &block, int lane, float w, float x, float y, float z) noexcept {
	const float fw = block.from_rotation[0][lane];
	const float fx = block.from_rotation[1][lane];
	const float fy = block.from_rotation[2][lane];
	const float fz = block.from_rotation[3][lane];
	pose.w = w * fw - x * fx - y * fy - z * fz;
	pose.x = w * fx + x * fw + y * fz - z * fy;
	pose.y = w * fy - x * fz + y * fw + z * fx;
	pose.z = w * fz + x * fy - y * fx + z * fw;
	pose.inverse_square = 1.0f;
}

// r^a = (cos(a theta/2), n sin(a theta/2)), t = a d, and the scale separately.
CGA_ALWAYS_INLINE LanePose separate_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float_math::SinCos half = float_math::sin_cos(a * block.half_angle[lane]);
	LanePose pose;
	set_rotation(pose, block, lane, half.cosine, half.sine * block.axis[0][lane], half.sine * block.axis[1][lane], half.sine * block.axis[2][lane]);
	pose.displacement_x = a * block.displacement[0][lane];
	pose.displacement_y = a * block.displacement[1][lane];
	pose.displacement_z = a * block.displacement[2][lane];
	pose.scale = block.from_scale[lane] * (1.0f - a) + block.to_scale[lane] * a;
	return pose;
}

// x clamped so that doubling it stays within the range of float. NaN (inf - inf) is clamped, too: comparisons with it are
// false.
CGA_ALWAYS_INLINE float saturated(float x) noexcept {
	constexpr float LARGEST = std::numeric_limits<float>::max() / 4.0f;
	return float_math::max(float_math::min(x, LARGEST), -LARGEST);
}

// With N = exp(a lambda) - 1 and c = N / (exp(lambda) - 1), the same with sigma along the axis n:
//   Re N = expm1(a sigma) - 2 exp(a sigma) sin(a theta/2)^2
//   Im N = exp(a sigma) 2 sin(a theta/2) cos(a theta/2)
//   t = c_along d_along + Re c d_across + Im c (n x d)     (d the displacement)
//   s = s_from exp(a sigma)
// The division was done when the pose was set. For a zero divisor, c = a.
CGA_ALWAYS_INLINE LanePose screw_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float_math::SinCos half = float_math::sin_cos(a * block.half_angle[lane]);
	const float_math::Exponential growth = float_math::exponential(a * block.log_scale[lane]);
	const float real = growth.minus_one - 2.0f * growth.value * half.sine * half.sine;
	const float imaginary = 2.0f * growth.value * half.sine * half.cosine;
	const float across_real = a * block.across_linear[lane] + (real * block.across[0][lane] - imaginary * block.across[1][lane]);
	const float across_imaginary = real * block.across[1][lane] + imaginary * block.across[0][lane];
	const float along = a * block.along_linear[lane] + growth.minus_one * block.along[lane];

	const float nx = block.axis[0][lane];
	const float ny = block.axis[1][lane];
	const float nz = block.axis[2][lane];
	const float dx = block.displacement[0][lane];
	const float dy = block.displacement[1][lane];
	const float dz = block.displacement[2][lane];
	const float axial = (along - across_real) * (nx * dx + ny * dy + nz * dz);

	LanePose pose;
	set_rotation(pose, block, lane, half.cosine, half.sine * nx, half.sine * ny, half.sine * nz);
	pose.displacement_x = across_real * dx + axial * nx + across_imaginary * (ny * dz - nz * dy);
	pose.displacement_y = across_real * dy + axial * ny + across_imaginary * (nz * dx - nx * dz);
	pose.displacement_z = across_real * dz + axial * nz + across_imaginary * (nx * dy - ny * dx);
	pose.scale = saturated(block.from_scale[lane] * growth.value + a * block.scale_change[lane]);
	return pose;
}

template <Mode MODE>
CGA_ALWAYS_INLINE LanePose lane_pose(const PoseBlock &block, int lane, float a) noexcept {
	if constexpr (MODE == Mode::LINEAR) {
		return linear_lane(block, lane, a);
	} else if constexpr (MODE == Mode::SCREW) {
		return screw_lane(block, lane, a);
	} else {
		return separate_lane(block, lane, a);
	}
}

// The weight, clamped to 0..1; for SCREW, to the range in which sin_cos() is precise.
template <Mode MODE>
CGA_ALWAYS_INLINE float clamped_weight(float weight) noexcept {
	constexpr float LOWEST = MODE == Mode::SCREW ? -1000.0f : 0.0f;
	constexpr float HIGHEST = MODE == Mode::SCREW ? 1000.0f : 1.0f;
	return float_math::max(LOWEST, float_math::min(HIGHEST, weight));
}

// Only extrapolation can leave the range of float.
template <Mode MODE>
CGA_ALWAYS_INLINE float origin(float from, float displacement) noexcept {
	return MODE == Mode::SCREW ? saturated(from + displacement) : from + displacement;
}

// basis = s R(q), with the squares of q divided by |q|^2. `weight_of(lane)` returns a clamped weight.
template <Mode MODE, class WeightOf>
CGA_ALWAYS_INLINE void interpolate_block(const PoseBlock &block, WeightOf weight_of, RowColumns &columns) noexcept {
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const LanePose pose = lane_pose<MODE>(block, lane, weight_of(lane));
		const float w = pose.w;
		const float x = pose.x;
		const float y = pose.y;
		const float z = pose.z;
		const float twice = 2.0f * pose.scale * pose.inverse_square;
		const float tx = twice * x;
		const float ty = twice * y;
		const float tz = twice * z;
		columns[0][lane] = (pose.scale - ty * y) - tz * z;
		columns[1][lane] = tx * y - tz * w;
		columns[2][lane] = tx * z + ty * w;
		columns[3][lane] = origin<MODE>(block.from_translation[0][lane], pose.displacement_x);
		columns[4][lane] = tx * y + tz * w;
		columns[5][lane] = (pose.scale - tx * x) - tz * z;
		columns[6][lane] = ty * z - tx * w;
		columns[7][lane] = origin<MODE>(block.from_translation[1][lane], pose.displacement_y);
		columns[8][lane] = tx * z - ty * w;
		columns[9][lane] = ty * z + tx * w;
		columns[10][lane] = (pose.scale - tx * x) - ty * y;
		columns[11][lane] = origin<MODE>(block.from_translation[2][lane], pose.displacement_z);
	}
}

} // namespace

} // namespace cga::kernel
