#pragma once

#include "cga/batch/row_transpose.hpp"

#include <algorithm>

// How kernels are run that make rows of 12 floats from blocks, or blocks from rows. What they compute for a block of bodies is
// the kernel's `compute(block, count, columns)`, of which the first `count` bodies are wanted; the way between columns and rows
// is here. The loops stand here once more for AVX2, since intrinsics of a set can only be inlined into a function for it.

namespace cga::kernel {

namespace detail {

template <InstructionSet set, class Kernel>
CGA_FLATTEN void write_each(const Kernel &kernel, size_t body_count, float *rows) noexcept {
	alignas(64) RowColumns columns;
	const size_t whole = body_count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		kernel.compute(block, BLOCK_LANES, columns);
		write_rows<set>(columns, rows + block * BLOCK_LANES * ROW_FLOATS);
	}
	if (const size_t rest = body_count % BLOCK_LANES; rest > 0) {
		float last_rows[BLOCK_LANES * ROW_FLOATS];
		kernel.compute(whole, rest, columns);
		write_rows<set>(columns, last_rows);
		std::copy_n(last_rows, rest * ROW_FLOATS, rows + whole * BLOCK_LANES * ROW_FLOATS);
	}
}

template <InstructionSet set, class Kernel>
CGA_FLATTEN void read_each(const Kernel &kernel, size_t body_count, const float *rows) noexcept {
	alignas(64) RowColumns columns;
	const size_t whole = body_count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		read_rows<set>(rows + block * BLOCK_LANES * ROW_FLOATS, columns);
		kernel.compute(block, BLOCK_LANES, columns);
	}
	if (const size_t rest = body_count % BLOCK_LANES; rest > 0) {
		float last_rows[BLOCK_LANES * ROW_FLOATS] = {};
		std::copy_n(rows + whole * BLOCK_LANES * ROW_FLOATS, rest * ROW_FLOATS, last_rows);
		read_rows<set>(last_rows, columns);
		kernel.compute(whole, rest, columns);
	}
}

template <class Kernel>
CGA_COMPILED_SCALAR void write_scalar(Kernel kernel, size_t body_count, float *rows) noexcept {
	write_each<InstructionSet::SCALAR>(kernel, body_count, rows);
}

template <class Kernel>
CGA_COMPILED_SCALAR void read_scalar(Kernel kernel, size_t body_count, const float *rows) noexcept {
	read_each<InstructionSet::SCALAR>(kernel, body_count, rows);
}

template <class Kernel>
CGA_COMPILED_BASELINE void write_baseline(Kernel kernel, size_t body_count, float *rows) noexcept {
	write_each<InstructionSet::BASELINE>(kernel, body_count, rows);
}

template <class Kernel>
CGA_COMPILED_BASELINE void read_baseline(Kernel kernel, size_t body_count, const float *rows) noexcept {
	read_each<InstructionSet::BASELINE>(kernel, body_count, rows);
}

#if defined(CGA_HAS_AVX2_FMA)
template <class Kernel>
CGA_COMPILED_AVX2_FMA void write_avx2_fma(Kernel kernel, size_t body_count, float *rows) noexcept {
	alignas(64) RowColumns columns;
	const size_t whole = body_count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		kernel.compute(block, BLOCK_LANES, columns);
		write_rows_avx2(columns, rows + block * BLOCK_LANES * ROW_FLOATS);
	}
	if (const size_t rest = body_count % BLOCK_LANES; rest > 0) {
		float last_rows[BLOCK_LANES * ROW_FLOATS];
		kernel.compute(whole, rest, columns);
		write_rows_avx2(columns, last_rows);
		std::copy_n(last_rows, rest * ROW_FLOATS, rows + whole * BLOCK_LANES * ROW_FLOATS);
	}
}

template <class Kernel>
CGA_COMPILED_AVX2_FMA void read_avx2_fma(Kernel kernel, size_t body_count, const float *rows) noexcept {
	alignas(64) RowColumns columns;
	const size_t whole = body_count / BLOCK_LANES;
	for (size_t block = 0; block < whole; ++block) {
		read_rows_avx2(rows + block * BLOCK_LANES * ROW_FLOATS, columns);
		kernel.compute(block, BLOCK_LANES, columns);
	}
	if (const size_t rest = body_count % BLOCK_LANES; rest > 0) {
		float last_rows[BLOCK_LANES * ROW_FLOATS] = {};
		std::copy_n(rows + whole * BLOCK_LANES * ROW_FLOATS, rest * ROW_FLOATS, last_rows);
		read_rows_avx2(last_rows, columns);
		kernel.compute(whole, rest, columns);
	}
}
#endif

} // namespace detail

// `rows` is what the kernel makes of its blocks.
template <class Kernel>
void write_rows_of(InstructionSet set, const Kernel &kernel, size_t body_count, float *rows) noexcept {
#if defined(CGA_HAS_AVX2_FMA)
	if (is_used(set, InstructionSet::AVX2_FMA)) {
		return detail::write_avx2_fma(kernel, body_count, rows);
	}
#endif
	if (set == InstructionSet::SCALAR) {
		return detail::write_scalar(kernel, body_count, rows);
	}
	detail::write_baseline(kernel, body_count, rows);
}

// The kernel makes its blocks of `rows`. Bodies of the last block beyond `body_count` have rows of zeros.
template <class Kernel>
void read_rows_into(InstructionSet set, const Kernel &kernel, size_t body_count, const float *rows) noexcept {
#if defined(CGA_HAS_AVX2_FMA)
	if (is_used(set, InstructionSet::AVX2_FMA)) {
		return detail::read_avx2_fma(kernel, body_count, rows);
	}
#endif
	if (set == InstructionSet::SCALAR) {
		return detail::read_scalar(kernel, body_count, rows);
	}
	detail::read_baseline(kernel, body_count, rows);
}

} // namespace cga::kernel
