#pragma once

#include "cga/batch/float_math.hpp"
#include "cga/batch/lane_access.hpp"

#include <limits>

// The kernels of pose pairs, for one lane; a loop of fixed length over the 8 lanes of a block vectorizes them. kernels.inl
// inlines them into functions for each instruction set.

namespace cga::kernel {

namespace {

// An interpolated pose, from which the basis and the origin are computed.
struct LanePose {
	LaneQuaternion rotation; // of the length 1 / sqrt(inverse_square)
	float inverse_square;
	LaneVector displacement; // relative to the position of `from`
	float scale;
};

// q = (1 - a) q_from + a q_to,  |q|^2 = (1 - a)^2 + a^2 + 2 a (1 - a) r_w = 1 - a (1 - a) (2 - 2 r_w)
// t = a (a d + (1 - a) e) / |q|^2     (d the displacement, e = r_w d + d x r_v the curvature)
// and the scale separately: interpolate_linear() in interpolate.cpp, with A q_from = q.
CGA_ALWAYS_INLINE LanePose linear_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float rest = 1.0f - a;
	const LaneQuaternion from = load_lane(block.from_rotation, lane), to = load_lane(block.to_rotation, lane);
	const LaneVector d = load_lane(block.displacement, lane), e = load_lane(block.curvature, lane);
	const float inverse_square = 1.0f / (1.0f - (a * rest) * block.shortening[lane]);
	const float factor = a * inverse_square;
	const float along = factor * a;
	const float across = factor * rest;
	return {
		{ rest * from.w + a * to.w, rest * from.x + a * to.x, rest * from.y + a * to.y, rest * from.z + a * to.z },
		inverse_square,
		{ along * d.x + across * e.x, along * d.y + across * e.y, along * d.z + across * e.z },
		rest * block.from_scale[lane] + a * block.to_scale[lane],
	};
}

// q = r^a q_from, r^a = (cos(a theta/2), n sin(a theta/2)), t = a d, and the scale separately.
CGA_ALWAYS_INLINE LanePose separate_lane(const PoseBlock &block, int lane, float a) noexcept {
	const float_math::SinCos half = float_math::sin_cos(a * block.half_angle[lane]);
	const LaneVector n = load_lane(block.axis, lane), d = load_lane(block.displacement, lane);
	return {
		product({ half.cosine, half.sine * n.x, half.sine * n.y, half.sine * n.z }, load_lane(block.from_rotation, lane)),
		1.0f,
		{ a * d.x, a * d.y, a * d.z },
		block.from_scale[lane] * (1.0f - a) + block.to_scale[lane] * a,
	};
}

// x clamped so that twice its value is within the range of float. NaN (inf - inf) becomes the limit: comparisons with it are
// false.
CGA_ALWAYS_INLINE float saturated(float x) noexcept {
	constexpr float LIMIT = std::numeric_limits<float>::max() / 4.0f;
	return float_math::max(float_math::min(x, LIMIT), -LIMIT);
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

	const LaneVector n = load_lane(block.axis, lane), d = load_lane(block.displacement, lane);
	const float axial = (along - across_real) * (n.x * d.x + n.y * d.y + n.z * d.z);
	return {
		product({ half.cosine, half.sine * n.x, half.sine * n.y, half.sine * n.z }, load_lane(block.from_rotation, lane)),
		1.0f,
		{
				across_real * d.x + axial * n.x + across_imaginary * (n.y * d.z - n.z * d.y),
				across_real * d.y + axial * n.y + across_imaginary * (n.z * d.x - n.x * d.z),
				across_real * d.z + axial * n.z + across_imaginary * (n.x * d.y - n.y * d.x),
		},
		saturated(block.from_scale[lane] * growth.value + a * block.scale_change[lane]),
	};
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
	constexpr float MIN_WEIGHT = MODE == Mode::SCREW ? -1000.0f : 0.0f;
	constexpr float MAX_WEIGHT = MODE == Mode::SCREW ? 1000.0f : 1.0f;
	return float_math::max(MIN_WEIGHT, float_math::min(MAX_WEIGHT, weight));
}

// Only extrapolation can leave the range of float.
template <Mode MODE>
CGA_ALWAYS_INLINE float origin(float from, float displacement) noexcept {
	return MODE == Mode::SCREW ? saturated(from + displacement) : from + displacement;
}

// `weight_of(lane)` returns a clamped weight.
template <Mode MODE, class WeightOf>
CGA_ALWAYS_INLINE void interpolate_block(const PoseBlock &block, WeightOf weight_of, RowColumns &columns) noexcept {
	for (int lane = 0; lane < PoseBlock::LANES; ++lane) {
		const LanePose pose = lane_pose<MODE>(block, lane, weight_of(lane));
		const LaneVector from = load_lane(block.from_translation, lane), moved = pose.displacement;
		store_pose(columns, lane, pose.rotation, pose.inverse_square, pose.scale, { origin<MODE>(from.x, moved.x), origin<MODE>(from.y, moved.y), origin<MODE>(from.z, moved.z) });
	}
}

} // namespace

} // namespace cga::kernel
