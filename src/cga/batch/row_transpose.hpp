#pragma once

#include "cga/batch/instruction_set.hpp"
#include "cga/batch/pose_block.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif

// From 12 quantities of 8 bodies each to 8 bodies of 12 floats, and back. gcc finds no shuffles for these loops, hence the
// intrinsics: transpositions of 4 x 4.

namespace cga::kernel {

// The 12 floats of a row, each for 8 bodies.
using RowColumns = PoseBlock::Row[ROW_FLOATS];

constexpr size_t BLOCK_LANES = size_t(PoseBlock::LANES);

#if defined(__SSE2__)
#define CGA_HAS_FOUR_FLOATS 1
using FourFloats = __m128;

CGA_FLATTEN FourFloats load_four(const float *source) noexcept {
	return _mm_loadu_ps(source);
}

CGA_FLATTEN void store_four(float *destination, FourFloats value) noexcept {
	_mm_storeu_ps(destination, value);
}

CGA_FLATTEN void transpose_four(FourFloats &first, FourFloats &second, FourFloats &third, FourFloats &fourth) noexcept {
	_MM_TRANSPOSE4_PS(first, second, third, fourth);
}
#elif defined(__ARM_NEON) && defined(__aarch64__)
#define CGA_HAS_FOUR_FLOATS 1
using FourFloats = float32x4_t;

CGA_FLATTEN FourFloats load_four(const float *source) noexcept {
	return vld1q_f32(source);
}

CGA_FLATTEN void store_four(float *destination, FourFloats value) noexcept {
	vst1q_f32(destination, value);
}

CGA_FLATTEN void transpose_four(FourFloats &first, FourFloats &second, FourFloats &third, FourFloats &fourth) noexcept {
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

#if defined(CGA_HAS_AVX2_FMA)
// Transposes each half of the registers by itself: bodies 0 to 3 below, 4 to 7 above.
__attribute__((target("avx2,fma"), always_inline)) inline void transpose_halves(__m256 &first, __m256 &second, __m256 &third, __m256 &fourth) noexcept {
	const __m256 low_left = _mm256_unpacklo_ps(first, second);
	const __m256 high_left = _mm256_unpackhi_ps(first, second);
	const __m256 low_right = _mm256_unpacklo_ps(third, fourth);
	const __m256 high_right = _mm256_unpackhi_ps(third, fourth);
	first = _mm256_shuffle_ps(low_left, low_right, 0x44);
	second = _mm256_shuffle_ps(low_left, low_right, 0xee);
	third = _mm256_shuffle_ps(high_left, high_right, 0x44);
	fourth = _mm256_shuffle_ps(high_left, high_right, 0xee);
}

// To a body's row and to that of the body 4 lanes on.
__attribute__((target("avx2,fma"), always_inline)) inline void store_halves(float *row, __m256 value) noexcept {
	_mm_storeu_ps(row, _mm256_castps256_ps128(value));
	_mm_storeu_ps(row + 4 * ROW_FLOATS, _mm256_extractf128_ps(value, 1));
}

// Whole registers, which the compiler takes from the arithmetic without a way through memory. Stores of 16 bytes and not
// of 32: joining two bodies costs a shuffle more for each, and a register.
__attribute__((target("avx2,fma"), always_inline)) inline void write_rows_avx2(const RowColumns &columns, float *rows) noexcept {
	for (size_t column = 0; column < ROW_FLOATS; column += 4) {
		__m256 first = _mm256_load_ps(columns[column]);
		__m256 second = _mm256_load_ps(columns[column + 1]);
		__m256 third = _mm256_load_ps(columns[column + 2]);
		__m256 fourth = _mm256_load_ps(columns[column + 3]);
		transpose_halves(first, second, third, fourth);
		store_halves(rows + column, first);
		store_halves(rows + ROW_FLOATS + column, second);
		store_halves(rows + 2 * ROW_FLOATS + column, third);
		store_halves(rows + 3 * ROW_FLOATS + column, fourth);
	}
}

__attribute__((target("avx2,fma"), always_inline)) inline void read_rows_avx2(const float *rows, RowColumns &columns) noexcept {
	for (size_t column = 0; column < ROW_FLOATS; column += 4) {
		__m256 quarter[4];
		for (size_t i = 0; i < 4; ++i) {
			const float *row = rows + i * ROW_FLOATS + column;
			quarter[i] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(row)), _mm_loadu_ps(row + 4 * ROW_FLOATS), 1);
		}
		transpose_halves(quarter[0], quarter[1], quarter[2], quarter[3]);
		for (size_t i = 0; i < 4; ++i) {
			_mm256_store_ps(columns[column + i], quarter[i]);
		}
	}
}
#endif

// For SCALAR and BASELINE; `columns` are aligned as a block is.
template <InstructionSet set>
CGA_FLATTEN void write_rows(const RowColumns &columns, float *rows) noexcept {
#if defined(CGA_HAS_FOUR_FLOATS)
	if constexpr (set == InstructionSet::BASELINE) {
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
		return;
	}
#endif
	for (size_t lane = 0; lane < BLOCK_LANES; ++lane) {
		for (size_t column = 0; column < ROW_FLOATS; ++column) {
			rows[lane * ROW_FLOATS + column] = columns[column][lane];
		}
	}
}

template <InstructionSet set>
CGA_FLATTEN void read_rows(const float *rows, RowColumns &columns) noexcept {
#if defined(CGA_HAS_FOUR_FLOATS)
	if constexpr (set == InstructionSet::BASELINE) {
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
		return;
	}
#endif
	for (size_t lane = 0; lane < BLOCK_LANES; ++lane) {
		for (size_t column = 0; column < ROW_FLOATS; ++column) {
			columns[column][lane] = rows[lane * ROW_FLOATS + column];
		}
	}
}

} // namespace cga::kernel
