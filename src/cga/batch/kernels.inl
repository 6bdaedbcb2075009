// The source of the batch kernels. Each kernels_<set>.cpp includes a row transpose for its set and then this file, which
// defines KERNELS. kernels.hpp says why no external inline function may be called here.

#include "cga/batch/kernels.hpp"
#include "cga/batch/motor_kernel.hpp"
#include "cga/batch/pose_kernel.hpp"

#include <cstring>

namespace cga::kernel {

namespace {

constexpr size_t POINT_FLOATS = 3;

// Writes the rows of `body_count` bodies. `kernel.compute(block, count, columns)` computes those of one block; only the
// first `count` are used.
template <class Kernel>
CGA_ALWAYS_INLINE void write_each_row(const Kernel &kernel, size_t body_count, float *rows) noexcept {
	alignas(64) RowColumns columns;
	const size_t whole = body_count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		kernel.compute(block, BLOCK_LANES, columns);
		write_rows(columns, rows + block * BLOCK_LANES * ROW_FLOATS);
	}
	if (const size_t rest = body_count % BLOCK_LANES; rest > 0) {
		float last_rows[BLOCK_LANES * ROW_FLOATS];
		kernel.compute(whole, rest, columns);
		write_rows(columns, last_rows);
		std::memcpy(rows + whole * BLOCK_LANES * ROW_FLOATS, last_rows, rest * ROW_FLOATS * sizeof(float));
	}
}

// One weight for all bodies.
template <Mode MODE>
struct WithOneWeight {
	const PoseBlock *blocks;
	float weight;

	CGA_ALWAYS_INLINE void compute(size_t block, size_t, RowColumns &columns) const noexcept {
		interpolate_block<MODE>(blocks[block], [this](int) { return weight; }, columns);
	}
};

// One weight for each body.
template <Mode MODE>
struct WithWeights {
	const PoseBlock *blocks;
	const float *weights;

	CGA_ALWAYS_INLINE void compute(size_t block, size_t count, RowColumns &columns) const noexcept {
		PoseBlock::Row lane_weights = {};
		for (size_t lane = 0; lane < count; ++lane) {
			lane_weights[lane] = weights[block * BLOCK_LANES + lane];
		}
		interpolate_block<MODE>(blocks[block], [&lane_weights](int lane) { return clamped_weight<MODE>(lane_weights[lane]); }, columns);
	}
};

template <Mode MODE>
void interpolate_with_mode(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, float *rows) noexcept {
	if (weights == nullptr) {
		write_each_row(WithOneWeight<MODE>{ blocks, clamped_weight<MODE>(weight) }, body_count, rows);
	} else {
		write_each_row(WithWeights<MODE>{ blocks, weights }, body_count, rows);
	}
}

void interpolate_blocks(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept {
	switch (mode) {
		case Mode::LINEAR:
			return interpolate_with_mode<Mode::LINEAR>(blocks, body_count, weights, weight, rows);
		case Mode::SCREW:
			return interpolate_with_mode<Mode::SCREW>(blocks, body_count, weights, weight, rows);
		case Mode::SEPARATE:
			return interpolate_with_mode<Mode::SEPARATE>(blocks, body_count, weights, weight, rows);
	}
}

void compose_blocks(const MotorBlock *first, const MotorBlock *second, size_t block_count, MotorBlock *products) noexcept {
	for (size_t block = 0; block < block_count; ++block) {
		compose_block(first[block], second[block], products[block]);
	}
}

void transform_by_matrix(const float *matrix, const float *points, size_t count, float *images) noexcept {
	float m[ROW_FLOATS]; // a copy, which `images` cannot alias
	std::memcpy(m, matrix, sizeof(m));
	CGA_INDEPENDENT_ITERATIONS
	for (size_t i = 0; i < count; ++i) {
		const float x = points[POINT_FLOATS * i];
		const float y = points[POINT_FLOATS * i + 1];
		const float z = points[POINT_FLOATS * i + 2];
		images[POINT_FLOATS * i] = (m[0] * x + m[1] * y) + (m[2] * z + m[3]);
		images[POINT_FLOATS * i + 1] = (m[4] * x + m[5] * y) + (m[6] * z + m[7]);
		images[POINT_FLOATS * i + 2] = (m[8] * x + m[9] * y) + (m[10] * z + m[11]);
	}
}

// `count` 1..8 points, the first of which belong to lane 0 of `motors`.
CGA_ALWAYS_INLINE void transform_lanes(const MotorBlock &motors, const float *points, size_t count, float *images) noexcept {
	alignas(64) PointColumns columns = {};
	for (size_t lane = 0; lane < count; ++lane) {
		for (size_t axis = 0; axis < POINT_FLOATS; ++axis) {
			columns[axis][lane] = points[lane * POINT_FLOATS + axis];
		}
	}
	transform_block(motors, columns);
	for (size_t lane = 0; lane < count; ++lane) {
		for (size_t axis = 0; axis < POINT_FLOATS; ++axis) {
			images[lane * POINT_FLOATS + axis] = columns[axis][lane];
		}
	}
}

void transform_points(const MotorBlock *motors, const float *points, size_t count, float *images) noexcept {
	const size_t whole = count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		const size_t offset = block * BLOCK_LANES * POINT_FLOATS;
		transform_lanes(motors[block], points + offset, BLOCK_LANES, images + offset);
	}
	if (const size_t rest = count % BLOCK_LANES; rest > 0) {
		const size_t offset = whole * BLOCK_LANES * POINT_FLOATS;
		transform_lanes(motors[whole], points + offset, rest, images + offset);
	}
}

struct Extraction {
	const MotorBlock *motors;

	CGA_ALWAYS_INLINE void compute(size_t block, size_t, RowColumns &columns) const noexcept { extract_block(motors[block], columns); }
};

void extract_blocks(const MotorBlock *motors, size_t body_count, float *rows) noexcept {
	write_each_row(Extraction{ motors }, body_count, rows);
}

void motors_from_rows(const float *rows, size_t body_count, MotorBlock *motors) noexcept {
	alignas(64) RowColumns columns;
	const size_t whole = body_count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		read_rows(rows + block * BLOCK_LANES * ROW_FLOATS, columns);
		motors_from_columns(columns, motors[block]);
	}
	if (const size_t rest = body_count % BLOCK_LANES; rest > 0) {
		float last_rows[BLOCK_LANES * ROW_FLOATS] = {};
		std::memcpy(last_rows, rows + whole * BLOCK_LANES * ROW_FLOATS, rest * ROW_FLOATS * sizeof(float));
		read_rows(last_rows, columns);
		motors_from_columns(columns, motors[whole]);
	}
}

constexpr Kernels KERNELS = { interpolate_blocks, compose_blocks, transform_by_matrix, transform_points, extract_blocks, motors_from_rows };

} // namespace

} // namespace cga::kernel
