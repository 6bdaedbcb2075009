// gcc leaves loops with comparisons scalar where these could raise a floating-point trap, which nothing here enables.
// No value depends on it. Before the includes, since it holds for the functions that follow.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-trapping-math")
#endif

#include "cga/batch/pose_block.hpp"

#include "cga/batch/pose_kernel.hpp"
#include "cga/batch/row_transpose.hpp"

#include <algorithm>

// The same kernels, compiled for the baseline of the platform and for AVX2. Neither contracts multiplications and
// additions, so that both give the same bits.

namespace cga {

namespace {

constexpr size_t LANES = PoseBlock::LANES;

template <Mode mode>
CGA_FLATTEN void run(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, float *rows) noexcept {
	alignas(64) PoseBlock::Row block_weights;
	alignas(64) kernel::RowColumns columns;
	std::fill_n(block_weights, LANES, kernel::allowed_weight<mode>(weight));

	for (size_t done = 0; done < body_count; done += LANES) {
		const size_t count = std::min(body_count - done, LANES);
		if (weights != nullptr) {
			for (size_t lane = 0; lane < count; ++lane) {
				block_weights[lane] = kernel::allowed_weight<mode>(weights[done + lane]);
			}
		}
		kernel::interpolate_block<mode>(blocks[done / LANES], block_weights, columns);
		if (count == LANES) {
			kernel::write_rows(columns, rows + done * ROW_FLOATS);
		} else {
			float last_rows[LANES * ROW_FLOATS];
			kernel::write_rows(columns, last_rows);
			std::copy_n(last_rows, count * ROW_FLOATS, rows + done * ROW_FLOATS);
		}
	}
}

CGA_FLATTEN void run_mode(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept {
	switch (mode) {
		case Mode::LINEAR:
			return run<Mode::LINEAR>(blocks, body_count, weights, weight, rows);
		case Mode::SCREW:
			return run<Mode::SCREW>(blocks, body_count, weights, weight, rows);
		case Mode::SEPARATE:
			return run<Mode::SEPARATE>(blocks, body_count, weights, weight, rows);
	}
}

} // namespace

namespace kernel {

void interpolate_blocks_baseline(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept {
	run_mode(blocks, body_count, weights, weight, mode, rows);
}

#if defined(CGA_HAS_AVX2_PATH)
__attribute__((target("avx2"))) void interpolate_blocks_avx2(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept {
	run_mode(blocks, body_count, weights, weight, mode, rows);
}
#endif

} // namespace kernel

void interpolate_blocks(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept {
#if defined(CGA_HAS_AVX2_PATH)
	static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
	if (has_avx2) {
		kernel::interpolate_blocks_avx2(blocks, body_count, weights, weight, mode, rows);
		return;
	}
#endif
	kernel::interpolate_blocks_baseline(blocks, body_count, weights, weight, mode, rows);
}

} // namespace cga
