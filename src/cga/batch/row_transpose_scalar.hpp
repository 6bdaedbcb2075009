#pragma once

#include "cga/batch/row_columns.hpp"

namespace cga::kernel {

namespace {

CGA_ALWAYS_INLINE void write_rows(const RowColumns &columns, float *rows) noexcept {
	for (size_t lane = 0; lane < BLOCK_LANES; ++lane) {
		for (size_t column = 0; column < ROW_FLOATS; ++column) {
			rows[lane * ROW_FLOATS + column] = columns[column][lane];
		}
	}
}

CGA_ALWAYS_INLINE void read_rows(const float *rows, RowColumns &columns) noexcept {
	for (size_t lane = 0; lane < BLOCK_LANES; ++lane) {
		for (size_t column = 0; column < ROW_FLOATS; ++column) {
			columns[column][lane] = rows[lane * ROW_FLOATS + column];
		}
	}
}

} // namespace

} // namespace cga::kernel
