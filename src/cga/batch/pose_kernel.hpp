#pragma once

#include "cga/batch/float_math.hpp"
#include "cga/batch/pose_block.hpp"

#include <limits>

// The batch kernels, for one lane each; a fixed loop over the 8 lanes of a block turns them into vector code. They
// are inlined into functions that are compiled for several instruction sets (interpolate_blocks.cpp).

namespace cga::kernel {

// One body between its poses: what the basis and the origin are made of.
struct LanePose {
	// The motion's rotation so far, to be composed with `from`'s; its length is 1 / sqrt(inverse_square).
	float w, x, y, z;
	float inverse_square;
	// From `from`'s position.
	float shift_x, shift_y, shift_z;
	float scale;
};

// A = (1 - a) + a turn
// t = a ((a + (1 - a) w) d + (1 - a) (d x turn_v)) / |A|^2     (d the shift)
// and the scale by itself: interpolate_linear() in interpolate.cpp.
CGA_FLATTEN LanePose linear_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float rest = 1.0f - a;
	const float w = block.turn[0][lane];
	const float x = block.turn[1][lane];
	const float y = block.turn[2][lane];
	const float z = block.turn[3][lane];
	const float dx = block.shift[0][lane];
	const float dy = block.shift[1][lane];
	const float dz = block.shift[2][lane];

	LanePose pose;
	pose.w = rest + a * w;
	pose.x = a * x;
	pose.y = a * y;
	pose.z = a * z;
	pose.inverse_square = 1.0f / ((pose.w * pose.w + pose.x * pose.x) + (pose.y * pose.y + pose.z * pose.z));
	const float factor = a * pose.inverse_square;
	const float straight = factor * (a + rest * w);
	const float turned = factor * rest;
	pose.shift_x = straight * dx + turned * (dy * z - dz * y);
	pose.shift_y = straight * dy + turned * (dz * x - dx * z);
	pose.shift_z = straight * dz + turned * (dx * y - dy * x);
	pose.scale = block.from_scale[lane] * rest + block.to_scale[lane] * a;
	return pose;
}

// turn^a = (cos(a theta/2), n sin(a theta/2)), t = a d, and the scale by itself.
CGA_FLATTEN LanePose separate_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float_math::SinCos half = float_math::sin_cos(a * block.half_angle[lane]);
	const float factor = half.sine * block.inverse_sine[lane];

	LanePose pose;
	pose.inverse_square = 1.0f;
	pose.w = half.cosine;
	pose.x = factor * block.turn[1][lane];
	pose.y = factor * block.turn[2][lane];
	pose.z = factor * block.turn[3][lane];
	pose.shift_x = a * block.shift[0][lane];
	pose.shift_y = a * block.shift[1][lane];
	pose.shift_z = a * block.shift[2][lane];
	pose.scale = block.from_scale[lane] * (1.0f - a) + block.to_scale[lane] * a;
	return pose;
}

// x kept where doubling it stays within float; not even inf - inf gets through, since comparisons with NaN are false.
CGA_FLATTEN float saturated(float x) noexcept {
	constexpr float LARGEST = std::numeric_limits<float>::max() / 4.0f;
	return float_math::max(float_math::min(x, LARGEST), -LARGEST);
}

// With N = exp(a lambda) - 1 and c = N / (exp(lambda) - 1), the same with sigma along the axis n:
//   Re N = expm1(a sigma) - 2 exp(a sigma) sin(a theta/2)^2
//   Im N = exp(a sigma) 2 sin(a theta/2) cos(a theta/2)
//   t = c_along d_along + Re c d_across + Im c (n x d)     (d the shift)
//   s = s_from exp(a sigma)
// The division was done when the pose was set. Where it is by zero, c = a.
CGA_FLATTEN LanePose screw_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float_math::SinCos half = float_math::sin_cos(a * block.half_angle[lane]);
	const float_math::Exponential growth = float_math::exponential(a * block.log_scale[lane]);
	const float real = growth.minus_one - 2.0f * growth.value * half.sine * half.sine;
	const float imaginary = 2.0f * growth.value * half.sine * half.cosine;
	const float across_real = a * block.across_linear[lane] + (real * block.across[0][lane] - imaginary * block.across[1][lane]);
	const float across_imaginary = real * block.across[1][lane] + imaginary * block.across[0][lane];
	const float along = a * block.along_linear[lane] + growth.minus_one * block.along[lane];

	const float nx = block.inverse_sine[lane] * block.turn[1][lane];
	const float ny = block.inverse_sine[lane] * block.turn[2][lane];
	const float nz = block.inverse_sine[lane] * block.turn[3][lane];
	const float dx = block.shift[0][lane];
	const float dy = block.shift[1][lane];
	const float dz = block.shift[2][lane];
	const float axial = (along - across_real) * (nx * dx + ny * dy + nz * dz);

	LanePose pose;
	pose.inverse_square = 1.0f;
	pose.w = half.cosine;
	pose.x = half.sine * nx;
	pose.y = half.sine * ny;
	pose.z = half.sine * nz;
	pose.shift_x = across_real * dx + axial * nx + across_imaginary * (ny * dz - nz * dy);
	pose.shift_y = across_real * dy + axial * ny + across_imaginary * (nz * dx - nx * dz);
	pose.shift_z = across_real * dz + axial * nz + across_imaginary * (nx * dy - ny * dx);
	pose.scale = saturated(block.from_scale[lane] * growth.value + a * block.scale_change[lane]);
	return pose;
}

template <Mode mode>
CGA_FLATTEN LanePose lane_pose(const PoseBlock &block, int lane, float a) noexcept {
	if constexpr (mode == Mode::LINEAR) {
		return linear_lane(block, lane, a);
	} else if constexpr (mode == Mode::SCREW) {
		return screw_lane(block, lane, a);
	} else {
		return separate_lane(block, lane, a);
	}
}

// What a weight is clamped to: the way between the poses, for SCREW the range in which sin_cos() is good.
template <Mode mode>
CGA_FLATTEN float allowed_weight(float weight) noexcept {
	constexpr float LOWEST = mode == Mode::SCREW ? -1000.0f : 0.0f;
	constexpr float HIGHEST = mode == Mode::SCREW ? 1000.0f : 1.0f;
	return float_math::max(LOWEST, float_math::min(HIGHEST, weight));
}

// Only extrapolation can leave the range of float.
template <Mode mode>
CGA_FLATTEN float origin(float from, float shift) noexcept {
	return mode == Mode::SCREW ? saturated(from + shift) : from + shift;
}

// The 12 floats of a row, each for 8 bodies.
using RowColumns = PoseBlock::Row[ROW_FLOATS];

// q = A q_from, as long as A; basis = s R(q), with the squares of q divided by |A|^2. `weights` are allowed ones.
template <Mode mode>
CGA_FLATTEN void interpolate_block(const PoseBlock &block, const PoseBlock::Row &weights, RowColumns &columns) noexcept {
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const LanePose pose = lane_pose<mode>(block, lane, weights[lane]);
		const float fw = block.from_rotation[0][lane];
		const float fx = block.from_rotation[1][lane];
		const float fy = block.from_rotation[2][lane];
		const float fz = block.from_rotation[3][lane];
		const float w = pose.w * fw - pose.x * fx - pose.y * fy - pose.z * fz;
		const float x = pose.w * fx + pose.x * fw + pose.y * fz - pose.z * fy;
		const float y = pose.w * fy - pose.x * fz + pose.y * fw + pose.z * fx;
		const float z = pose.w * fz + pose.x * fy - pose.y * fx + pose.z * fw;
		const float twice = 2.0f * pose.scale * pose.inverse_square;
		const float tx = twice * x;
		const float ty = twice * y;
		const float tz = twice * z;
		columns[0][lane] = pose.scale - (ty * y + tz * z);
		columns[1][lane] = tx * y - tz * w;
		columns[2][lane] = tx * z + ty * w;
		columns[3][lane] = origin<mode>(block.from_translation[0][lane], pose.shift_x);
		columns[4][lane] = tx * y + tz * w;
		columns[5][lane] = pose.scale - (tx * x + tz * z);
		columns[6][lane] = ty * z - tx * w;
		columns[7][lane] = origin<mode>(block.from_translation[1][lane], pose.shift_y);
		columns[8][lane] = tx * z - ty * w;
		columns[9][lane] = ty * z + tx * w;
		columns[10][lane] = pose.scale - (tx * x + ty * y);
		columns[11][lane] = origin<mode>(block.from_translation[2][lane], pose.shift_z);
	}
}

// interpolate_blocks() for one instruction set each, which it chooses from at run time.
void interpolate_blocks_baseline(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept;
#if defined(__GNUC__) && defined(__x86_64__)
#define CGA_HAS_AVX2_PATH 1
void interpolate_blocks_avx2(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept;
#endif

} // namespace cga::kernel
