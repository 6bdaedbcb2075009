#pragma once

namespace cga {

// The instruction sets that the batch kernels (kernels.hpp) are compiled for.
//
// SCALAR and BASELINE round every operation, in the same order: they give the same bits, on every machine. AVX2_FMA fuses
// multiplications with additions, which rounds once, and agrees with them to 1e-6 of the result's size.
enum class InstructionSet {
	SCALAR, // one body at a time: the reference for the others
	BASELINE, // what every processor of the platform has: SSE2 on x86-64, NEON on arm64
	AVX2_FMA, // x86-64 since about 2013
};

// The fastest one that this machine supports.
[[nodiscard]] InstructionSet best_instruction_set() noexcept;

} // namespace cga
