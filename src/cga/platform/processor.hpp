#pragma once

namespace cga {

// Instruction set extensions beyond the platform's baseline that both the processor and the operating system support.
struct ProcessorFeatures {
	bool avx2 = false;
	bool fma = false;
};

// The features of the processor that runs the program; all false on processors other than x86-64.
[[nodiscard]] const ProcessorFeatures &processor_features() noexcept;

} // namespace cga
