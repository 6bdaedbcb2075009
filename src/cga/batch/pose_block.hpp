#pragma once

#include "cga/batch/instruction_set.hpp"
#include "cga/motor/interpolate.hpp"
#include "cga/motor/pose.hpp"

#include <cstddef>

namespace cga {

// The pose pairs of 8 bodies, laid out for the batch kernels: one row of 8 floats for each quantity (AoSoA).
//
// A block holds the first pose of each body and the motion from it to the second: the rotation r = q_to q_from*, with the
// hemisphere chosen (r_w >= 0) when a pose is set, and the displacement t_to - t_from. The kernels add this small motion to a
// large position, so that they are as precise 10 km away as at the origin. Everything that does not depend on the weight is
// computed when a pose is set: products for LINEAR, logarithms for SCREW.
//
// The rows that a mode reads are adjacent; LINEAR reads only the first 20, 640 bytes. The size is an odd number of cache
// lines, so that the same rows of all blocks spread over all sets of a cache.
struct alignas(64) PoseBlock {
	static constexpr int LANES = 8;
	using Row = float[LANES];

	// All modes.
	Row from_rotation[4]; // w, x, y, z
	Row from_translation[3];
	Row from_scale;
	Row to_scale;
	Row displacement[3];

	// LINEAR.
	Row to_rotation[4]; // w, x, y, z; the one of q_to and -q_to that is nearer to q_from
	Row shortening; // 2 - 2 r_w: the blend with weight w has the squared length 1 - w (1 - w) shortening
	Row curvature[3]; // r_w d + d x r_v, d the displacement

	// SCREW and SEPARATE. lambda = sigma + i theta is the logarithm of scale and rotation; screw_lane() in
	// pose_kernel.hpp multiplies by the last five rows.
	Row axis[3]; // of the rotation; 0 without one
	Row half_angle; // theta / 2, 0..pi/2
	Row log_scale; // sigma; 0 if a scale is not positive
	Row scale_change; // s_to - s_from if a scale is not positive, else 0
	Row across[2]; // 1 / (exp(lambda) - 1), real and imaginary; 0 if lambda = 0
	Row across_linear; // 1 if lambda = 0, else 0
	Row along; // 1 / (exp(sigma) - 1); 0 if sigma = 0
	Row along_linear; // 1 if sigma = 0, else 0

	// For get_from() and get_to() to return what was set, bit for bit; the kernels do not read these.
	Row hemisphere; // -1 where to_rotation is -q_to, else 1
	Row to_translation[3];

	// All poses are the identity.
	PoseBlock() noexcept;

	// `lane` 0..7. Rotations are normalized; scales must be positive (interpolate.hpp says what others do).
	void set(int lane, const Pose<float> &from, const Pose<float> &to) noexcept;
	void set_from(int lane, const Pose<float> &from) noexcept;
	void set_to(int lane, const Pose<float> &to) noexcept;
	[[nodiscard]] Pose<float> get_from(int lane) const noexcept;
	[[nodiscard]] Pose<float> get_to(int lane) const noexcept;
};

// The number of blocks that hold `body_count` bodies.
[[nodiscard]] constexpr size_t block_count(size_t body_count) noexcept {
	return (body_count + PoseBlock::LANES - 1) / PoseBlock::LANES;
}

inline constexpr size_t ROW_FLOATS = 12;

// Interpolates the first `body_count` bodies of `blocks` and writes 12 floats for each to `rows`, in the layout of
// a MultiMesh's 3D transforms: basis row 0 (x, y, z), origin x, basis row 1, origin y, basis row 2, origin z, scale
// included. `weights` holds one weight for each body; if it is null, all bodies use `weight`.
//
// Agrees with interpolate() to 1e-5 (and float's rounding of the position) for translations below 1e37 and scales within
// 1e37 of each other; finite input always gives finite output. SCREW clamps the weight to -1,000..1,000. Allocates nothing;
// threads may work on different bodies. The result is the same, bit for bit, however the bodies are split into calls and
// wherever a body is in its block; instruction_set.hpp says how it depends on the instruction set.
void interpolate_blocks(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows,
		InstructionSet set = best_instruction_set()) noexcept;

// A pose as 12 floats in that layout, and back. A row whose basis is not a rotation times a positive scale gives the identity
// at the row's origin.
void pose_to_row(const Pose<float> &pose, float *row) noexcept;
[[nodiscard]] Pose<float> pose_from_row(const float *row) noexcept;

} // namespace cga
