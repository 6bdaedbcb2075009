// gcc leaves loops with comparisons scalar where these could raise a floating-point trap, which nothing here enables.
// No value depends on it. Before the includes, since it holds for the functions that follow.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-trapping-math")
#endif

#include "cga/pose_block.hpp"

#include "cga/pose_kernel.hpp"
#include "cga/row_transpose.hpp"

#include <algorithm>

// The same kernels, compiled for the baseline of the platform and for AVX2, chosen at run time. Neither contracts
// multiplications and additions, so that both give the same bits.
#if defined(__GNUC__) && defined(__x86_64__)
#define CGA_HAS_AVX2_PATH 1
#endif

namespace cga {

namespace {

constexpr size_t LANES = PoseBlock::LANES;

template <Mode mode>
CGA_FLATTEN void run(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, float *rows) noexcept {
	alignas(64) float block_weights[LANES];
	alignas(64) kernel::RowColumns columns;
	std::fill_n(block_weights, LANES, weight);

	const size_t whole_blocks = body_count / LANES;
	for (size_t block = 0; block < whole_blocks; ++block) {
		kernel::interpolate_block<mode>(blocks[block], weights != nullptr ? weights + block * LANES : block_weights, columns);
		kernel::write_rows(columns, rows + block * LANES * ROW_FLOATS);
	}

	const size_t done = whole_blocks * LANES;
	const size_t left = body_count - done;
	if (left > 0) {
		if (weights != nullptr) {
			std::copy_n(weights + done, left, block_weights);
		}
		float last_rows[LANES * ROW_FLOATS];
		kernel::interpolate_block<mode>(blocks[whole_blocks], block_weights, columns);
		kernel::write_rows(columns, last_rows);
		std::copy_n(last_rows, left * ROW_FLOATS, rows + done * ROW_FLOATS);
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
