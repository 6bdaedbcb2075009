#pragma once

#include "cga/flatten.hpp"

// The batch kernels are one source, compiled once for each set of instructions.
//
// A kernel is a struct of inputs with a `run()`, or for what reads or writes rows a `compute()` (row_kernel.hpp), always inlined
// into functions that are compiled for a set, in which the loops over the 8 lanes of a block become vector instructions.
//
// SCALAR and BASELINE round every operation, in the same order: they give the same bits, on every machine. AVX2_FMA rounds a
// multiplication and the addition after it once, and agrees with them to 1e-6 of the result's size.

namespace cga {

enum class InstructionSet {
	SCALAR, // one body at a time: what the others are compared with
	BASELINE, // what each processor of the platform has: SSE2 on x86-64, NEON on arm64
	AVX2_FMA, // x86-64 since about 2013
};

#if defined(__GNUC__) && defined(__x86_64__)
#define CGA_HAS_AVX2_FMA 1
#endif

// The fastest of this machine.
[[nodiscard]] inline InstructionSet best_instruction_set() noexcept {
#if defined(CGA_HAS_AVX2_FMA)
	static const bool has_avx2_fma = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
	return has_avx2_fma ? InstructionSet::AVX2_FMA : InstructionSet::BASELINE;
#else
	return InstructionSet::BASELINE;
#endif
}

namespace kernel {

// Whether a kernel that is asked for `set` runs on `candidate`. It runs on BASELINE where this machine lacks `set`.
[[nodiscard]] inline bool is_used(InstructionSet set, InstructionSet candidate) noexcept {
	return set == candidate && (set != InstructionSet::AVX2_FMA || best_instruction_set() == InstructionSet::AVX2_FMA);
}

// What the functions for a set are compiled with. Kernels are passed by value, so that no store can change them.
#if defined(__GNUC__) && !defined(__clang__)
#define CGA_COMPILED_SCALAR __attribute__((optimize("no-tree-vectorize")))
#define CGA_COMPILED_BASELINE
#define CGA_COMPILED_AVX2_FMA __attribute__((target("avx2,fma"), optimize("fp-contract=fast")))
#else
#define CGA_COMPILED_SCALAR
#define CGA_COMPILED_BASELINE
#define CGA_COMPILED_AVX2_FMA __attribute__((target("avx2,fma")))
#endif

namespace detail {

template <class Kernel>
CGA_COMPILED_SCALAR void run_scalar(Kernel kernel) noexcept {
	kernel.run();
}

template <class Kernel>
CGA_COMPILED_BASELINE void run_baseline(Kernel kernel) noexcept {
	kernel.run();
}

#if defined(CGA_HAS_AVX2_FMA)
template <class Kernel>
CGA_COMPILED_AVX2_FMA void run_avx2_fma(Kernel kernel) noexcept {
	kernel.run();
}
#endif

} // namespace detail

template <class Kernel>
void run_kernel(InstructionSet set, const Kernel &kernel) noexcept {
#if defined(CGA_HAS_AVX2_FMA)
	if (is_used(set, InstructionSet::AVX2_FMA)) {
		return detail::run_avx2_fma(kernel);
	}
#endif
	if (set == InstructionSet::SCALAR) {
		return detail::run_scalar(kernel);
	}
	detail::run_baseline(kernel);
}

} // namespace kernel

} // namespace cga
