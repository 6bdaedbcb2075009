#pragma once

#include "cga/batch/instruction_set.hpp"
#include "cga/motor/interpolate.hpp"
#include "cga/motor/pose.hpp"

#include <cstddef>

namespace cga {

// The pairs of poses of 8 bodies, laid out for the batch kernels: one row of 8 floats for each quantity (AoSoA).
//
// Of each body the block keeps the pose it comes from and its motion relative to that pose: turn = q_to q_from*,
// with the hemisphere fixed (w >= 0) when the pose is set, and shift = t_to - t_from. The kernels add small motions to
// large positions, so that they are as precise 10 km away as at the origin. What depends on both poses and not on the
// weight is computed when a pose is set: products for LINEAR, logarithms for SCREW.
//
// The rows that a mode reads stand together; LINEAR reads the first 20 alone, 640 bytes. A block is 17 cache lines,
// not 16, so that the same rows of all blocks spread over all sets of a cache.
struct alignas(64) PoseBlock {
	static constexpr int LANES = 8;
	using Row = float[LANES];

	// All modes.
	Row from_rotation[4]; // w, x, y, z
	Row from_translation[3];
	Row from_scale;
	Row to_scale;
	Row shift[3];

	// LINEAR.
	Row to_rotation[4]; // w, x, y, z; of q_to and -q_to the one nearer to q_from
	Row shrinking; // 2 - 2 turn_w: how much shorter than 1 a blend of the rotations gets
	Row bend[3]; // shift times turn's scalar part + shift x its vector part

	// SCREW and SEPARATE. lambda = sigma + i theta is the logarithm of scale and turn; see screw_lane() in
	// pose_kernel.hpp for what the last five are factors of.
	Row axis[3]; // of the turn; 0 where there is none
	Row half_angle; // theta / 2, 0..pi/2
	Row log_scale; // sigma; 0 if a scale is not positive
	Row scale_change; // s_to - s_from if a scale is not positive, else 0
	Row across[2]; // 1 / (exp(lambda) - 1), real and imaginary; 0 if lambda = 0
	Row across_linear; // 1 if lambda = 0, else 0
	Row along; // 1 / (exp(sigma) - 1); 0 if sigma = 0
	Row along_linear; // 1 if sigma = 0, else 0

	// With these, what was set is known to the bit; not read by the kernels.
	Row hemisphere; // -1 where to_rotation is -q_to, else 1
	Row to_translation[3];

	// All bodies at the identity.
	PoseBlock() noexcept;

	// `lane` 0..7. Rotations are normalised; scales are positive by contract (interpolate.hpp says what else does).
	void set(int lane, const Pose<float> &from, const Pose<float> &to) noexcept;
	void set_from(int lane, const Pose<float> &from) noexcept;
	void set_to(int lane, const Pose<float> &to) noexcept;
	[[nodiscard]] Pose<float> get_from(int lane) const noexcept;
	[[nodiscard]] Pose<float> get_to(int lane) const noexcept;
};

// Blocks for `body_count` bodies.
[[nodiscard]] constexpr size_t block_count(size_t body_count) noexcept {
	return (body_count + PoseBlock::LANES - 1) / PoseBlock::LANES;
}

inline constexpr size_t ROW_FLOATS = 12;

// Interpolates the first `body_count` bodies of `blocks` and writes 12 floats for each to `rows`, in the layout of
// a MultiMesh's 3D transforms: basis row 0 (x, y, z), origin x, basis row 1, origin y, basis row 2, origin z, scale
// included. `weights` holds one weight a body; if it is null, `weight` is every body's.
//
// Agrees with interpolate() to 1e-5 (and float's rounding of the position), where translations are below 1e37 and
// scales within 1e37 of each other; finite input gives finite output there and beyond. SCREW clamps the weight to
// -1,000..1,000. Allocates nothing; different bodies may be done on different threads. The result does not depend,
// to the bit, on how the bodies are split into calls, nor on a body's place in its block. Between sets of instructions it
// differs as instruction_set.hpp says: with BASELINE it is the same, to the bit, on every machine.
void interpolate_blocks(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows,
		InstructionSet set = best_instruction_set()) noexcept;

// A pose as 12 floats of that layout, and back. A row whose basis is not a rotation times a positive scale gives the
// identity at the row's origin.
void pose_to_row(const Pose<float> &pose, float *row) noexcept;
[[nodiscard]] Pose<float> pose_from_row(const float *row) noexcept;

} // namespace cga
