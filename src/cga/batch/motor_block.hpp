#pragma once

#include "cga/batch/instruction_set.hpp"
#include "cga/batch/pose_block.hpp"
#include "cga/motor/motor.hpp"

namespace cga {

// 8 motors: one row of 8 floats for each coefficient of the minimal form (motor.hpp).
struct alignas(64) MotorBlock {
	static constexpr int LANES = PoseBlock::LANES;
	using Row = PoseBlock::Row;

	Row a[4]; // w, x, y, z
	Row b[4];
	Row v[4];

	// All motors are the identity.
	MotorBlock() noexcept;

	// `lane` 0..7.
	void set(int lane, const Motor<float> &motor) noexcept;
	[[nodiscard]] Motor<float> get(int lane) const noexcept;
};

// None of these functions allocates; threads may work on different blocks. They agree with motor.hpp to 1e-6 of the result's
// size.

// products[i] = first[i] second[i], lane by lane; `second` acts first. `products` may be one of the factors.
void compose_blocks(const MotorBlock *first, const MotorBlock *second, size_t block_count, MotorBlock *products, InstructionSet set = best_instruction_set()) noexcept;

// The images of `count` points, 3 floats each, under one motor, whose weight must not be zero. `images` may be `points`.
void transform_points(const Motor<float> &motor, const float *points, size_t count, float *images, InstructionSet set = best_instruction_set()) noexcept;

// The image of point i under motor i, for `count` motors. A motor of weight zero maps its point to the origin.
void transform_points(const MotorBlock *motors, const float *points, size_t count, float *images, InstructionSet set = best_instruction_set()) noexcept;

// The poses of the first `body_count` motors, of any weight, as rows of 12 floats (interpolate_blocks()). A motor of weight
// zero gives zeros, which renders nothing.
void extract_blocks(const MotorBlock *motors, size_t body_count, float *rows, InstructionSet set = best_instruction_set()) noexcept;

// The motors of unit weight of `body_count` such rows, in block_count(body_count) blocks; unused lanes of the last one get
// motors of weight zero. Each basis must be a rotation times a positive scale, which is not checked (pose_from_row() does).
void motors_from_rows(const float *rows, size_t body_count, MotorBlock *motors, InstructionSet set = best_instruction_set()) noexcept;

} // namespace cga
