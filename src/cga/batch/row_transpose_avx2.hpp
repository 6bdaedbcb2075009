#pragma once

#include "cga/batch/row_columns.hpp"

#include <immintrin.h>

namespace cga::kernel {

namespace {

// Transposes 4 x 4 floats in each 128-bit half of the registers: bodies 0 to 3 in the low halves, 4 to 7 in the high ones.
CGA_ALWAYS_INLINE void transpose_halves(__m256 &first, __m256 &second, __m256 &third, __m256 &fourth) noexcept {
	const __m256 low_left = _mm256_unpacklo_ps(first, second);
	const __m256 high_left = _mm256_unpackhi_ps(first, second);
	const __m256 low_right = _mm256_unpacklo_ps(third, fourth);
	const __m256 high_right = _mm256_unpackhi_ps(third, fourth);
	first = _mm256_shuffle_ps(low_left, low_right, 0x44);
	second = _mm256_shuffle_ps(low_left, low_right, 0xee);
	third = _mm256_shuffle_ps(high_left, high_right, 0x44);
	fourth = _mm256_shuffle_ps(high_left, high_right, 0xee);
}

// Stores the low half to a body's row and the high half to the row of the body 4 lanes later.
CGA_ALWAYS_INLINE void store_halves(float *row, __m256 value) noexcept {
	_mm_storeu_ps(row, _mm256_castps256_ps128(value));
	_mm_storeu_ps(row + 4 * ROW_FLOATS, _mm256_extractf128_ps(value, 1));
}

// Loads whole registers, so that the compiler keeps the columns in registers. Stores 16 bytes at a time: each 32-byte store would
// need another shuffle and another register.
CGA_ALWAYS_INLINE void write_rows(const RowColumns &columns, float *rows) noexcept {
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

CGA_ALWAYS_INLINE void read_rows(const float *rows, RowColumns &columns) noexcept {
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

} // namespace

} // namespace cga::kernel
