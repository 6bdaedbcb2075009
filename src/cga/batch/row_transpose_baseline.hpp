#pragma once

#include "cga/batch/row_columns.hpp"

#if CGA_X86_64
#include <emmintrin.h>
#elif CGA_ARM64
#include <arm_neon.h>
#else
#include "cga/batch/row_transpose_scalar.hpp"
#endif

#if CGA_X86_64 || CGA_ARM64

// Transposes of 4 x 4 floats, with SSE2 or NEON.

namespace cga::kernel {

namespace {

#if CGA_X86_64
using FourFloats = __m128;

CGA_ALWAYS_INLINE FourFloats load_four(const float *source) noexcept {
	return _mm_loadu_ps(source);
}

CGA_ALWAYS_INLINE void store_four(float *destination, FourFloats value) noexcept {
	_mm_storeu_ps(destination, value);
}

CGA_ALWAYS_INLINE void transpose_four(FourFloats &first, FourFloats &second, FourFloats &third, FourFloats &fourth) noexcept {
	_MM_TRANSPOSE4_PS(first, second, third, fourth);
}
#else
using FourFloats = float32x4_t;

CGA_ALWAYS_INLINE FourFloats load_four(const float *source) noexcept {
	return vld1q_f32(source);
}

CGA_ALWAYS_INLINE void store_four(float *destination, FourFloats value) noexcept {
	vst1q_f32(destination, value);
}

CGA_ALWAYS_INLINE void transpose_four(FourFloats &first, FourFloats &second, FourFloats &third, FourFloats &fourth) noexcept {
	const float64x2_t even_low = vreinterpretq_f64_f32(vtrn1q_f32(first, second));
	const float64x2_t odd_low = vreinterpretq_f64_f32(vtrn2q_f32(first, second));
	const float64x2_t even_high = vreinterpretq_f64_f32(vtrn1q_f32(third, fourth));
	const float64x2_t odd_high = vreinterpretq_f64_f32(vtrn2q_f32(third, fourth));
	first = vreinterpretq_f32_f64(vtrn1q_f64(even_low, even_high));
	second = vreinterpretq_f32_f64(vtrn1q_f64(odd_low, odd_high));
	third = vreinterpretq_f32_f64(vtrn2q_f64(even_low, even_high));
	fourth = vreinterpretq_f32_f64(vtrn2q_f64(odd_low, odd_high));
}
#endif

CGA_ALWAYS_INLINE void write_rows(const RowColumns &columns, float *rows) noexcept {
	for (size_t lane = 0; lane < BLOCK_LANES; lane += 4) {
		for (size_t column = 0; column < ROW_FLOATS; column += 4) {
			FourFloats quarter[4];
			for (size_t i = 0; i < 4; ++i) {
				quarter[i] = load_four(columns[column + i] + lane);
			}
			transpose_four(quarter[0], quarter[1], quarter[2], quarter[3]);
			for (size_t i = 0; i < 4; ++i) {
				store_four(rows + (lane + i) * ROW_FLOATS + column, quarter[i]);
			}
		}
	}
}

CGA_ALWAYS_INLINE void read_rows(const float *rows, RowColumns &columns) noexcept {
	for (size_t lane = 0; lane < BLOCK_LANES; lane += 4) {
		for (size_t column = 0; column < ROW_FLOATS; column += 4) {
			FourFloats quarter[4];
			for (size_t i = 0; i < 4; ++i) {
				quarter[i] = load_four(rows + (lane + i) * ROW_FLOATS + column);
			}
			transpose_four(quarter[0], quarter[1], quarter[2], quarter[3]);
			for (size_t i = 0; i < 4; ++i) {
				store_four(columns[column + i] + lane, quarter[i]);
			}
		}
	}
}

} // namespace

} // namespace cga::kernel

#endif
