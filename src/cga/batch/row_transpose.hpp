#pragma once

#include "cga/batch/pose_kernel.hpp"

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#define CGA_HAS_SSE 1
#endif

namespace cga::kernel {

// From 12 quantities of 8 bodies to 8 bodies of 12 floats. gcc finds no shuffles for this loop, hence the intrinsics:
// six transpositions of 4 x 4.
CGA_FLATTEN void write_rows(const RowColumns &columns, float *rows) noexcept {
#if defined(CGA_HAS_SSE)
	constexpr size_t WIDTH = 4;
	for (size_t lane = 0; lane < size_t(PoseBlock::LANES); lane += WIDTH) {
		for (size_t column = 0; column < ROW_FLOATS; column += WIDTH) {
			__m128 first = _mm_load_ps(columns[column] + lane);
			__m128 second = _mm_load_ps(columns[column + 1] + lane);
			__m128 third = _mm_load_ps(columns[column + 2] + lane);
			__m128 fourth = _mm_load_ps(columns[column + 3] + lane);
			_MM_TRANSPOSE4_PS(first, second, third, fourth);
			float *corner = rows + lane * ROW_FLOATS + column;
			_mm_storeu_ps(corner, first);
			_mm_storeu_ps(corner + ROW_FLOATS, second);
			_mm_storeu_ps(corner + 2 * ROW_FLOATS, third);
			_mm_storeu_ps(corner + 3 * ROW_FLOATS, fourth);
		}
	}
#else
	for (size_t lane = 0; lane < size_t(PoseBlock::LANES); ++lane) {
		for (size_t column = 0; column < ROW_FLOATS; ++column) {
			rows[lane * ROW_FLOATS + column] = columns[column][lane];
		}
	}
#endif
}

} // namespace cga::kernel
