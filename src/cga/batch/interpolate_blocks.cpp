#include "cga/batch/pose_block.hpp"

#include "cga/batch/pose_kernel.hpp"
#include "cga/batch/row_kernel.hpp"

#include <algorithm>

namespace cga {

namespace {

// One weight for every body.
template <Mode mode>
struct WithOneWeight {
	const PoseBlock *blocks;
	float weight;

	CGA_FLATTEN void compute(size_t block, size_t, kernel::RowColumns &columns) const noexcept {
		kernel::interpolate_block<mode>(blocks[block], [this](int) { return weight; }, columns);
	}
};

// A weight for each body.
template <Mode mode>
struct WithWeights {
	const PoseBlock *blocks;
	const float *weights;

	CGA_FLATTEN void compute(size_t block, size_t count, kernel::RowColumns &columns) const noexcept {
		PoseBlock::Row own = {};
		std::copy_n(weights + block * kernel::BLOCK_LANES, count, own);
		kernel::interpolate_block<mode>(blocks[block], [&own](int lane) { return kernel::allowed_weight<mode>(own[lane]); }, columns);
	}
};

template <Mode mode>
void run(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, float *rows, InstructionSet set) noexcept {
	if (weights == nullptr) {
		kernel::write_rows_of(set, WithOneWeight<mode>{ blocks, kernel::allowed_weight<mode>(weight) }, body_count, rows);
	} else {
		kernel::write_rows_of(set, WithWeights<mode>{ blocks, weights }, body_count, rows);
	}
}

} // namespace

void interpolate_blocks(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows, InstructionSet set) noexcept {
	switch (mode) {
		case Mode::LINEAR:
			return run<Mode::LINEAR>(blocks, body_count, weights, weight, rows, set);
		case Mode::SCREW:
			return run<Mode::SCREW>(blocks, body_count, weights, weight, rows, set);
		case Mode::SEPARATE:
			return run<Mode::SEPARATE>(blocks, body_count, weights, weight, rows, set);
	}
}

} // namespace cga
