#pragma once

#include "cga/batch/instruction_set.hpp"
#include "cga/batch/pose_block.hpp"
#include "cga/motor/motor.hpp"

namespace cga {

// 8 motors, one row of 8 floats for each coefficient of their minimal form (motor.hpp).
struct alignas(64) MotorBlock {
	static constexpr int LANES = PoseBlock::LANES;
	using Row = PoseBlock::Row;

	Row a[4]; // w, x, y, z
	Row b[4];
	Row v[4];

	// All at the identity.
	MotorBlock() noexcept;

	// `lane` 0..7.
	void set(int lane, const Motor<float> &motor) noexcept;
	[[nodiscard]] Motor<float> get(int lane) const noexcept;
};

// All of these allocate nothing, may work on different blocks on different threads, and agree with the functions of motor.hpp
// to 1e-6 of the result's size.

// products[i] = first[i] second[i], each lane by itself; `second` acts first. `products` may be one of the factors.
void compose_blocks(const MotorBlock *first, const MotorBlock *second, size_t block_count, MotorBlock *products, InstructionSet set = best_instruction_set()) noexcept;

// Where one motor carries `count` points, 3 floats each. `images` may be `points`. The motor's weight is not zero.
void transform_points(const Motor<float> &motor, const float *points, size_t count, float *images, InstructionSet set = best_instruction_set()) noexcept;

// Where each of `count` motors carries a point of its own. A motor of weight zero carries its point to the origin.
void transform_points(const MotorBlock *motors, const float *points, size_t count, float *images, InstructionSet set = best_instruction_set()) noexcept;

// The poses of the first `body_count` motors, of any weight, as rows of 12 floats as interpolate_blocks() writes them. A motor
// of weight zero gives zeros, which shows nothing.
void extract_blocks(const MotorBlock *motors, size_t body_count, float *rows, InstructionSet set = best_instruction_set()) noexcept;

// The motors of unit weight of `body_count` such rows, into block_count(body_count) blocks, whose last lanes may get motors of
// weight zero. A basis is a rotation times a positive scale, as pose_from_row() would check and this does not.
void motors_from_rows(const float *rows, size_t body_count, MotorBlock *motors, InstructionSet set = best_instruction_set()) noexcept;

} // namespace cga
