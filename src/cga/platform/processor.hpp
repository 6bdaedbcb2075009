#pragma once

namespace cga {

// Instructions beyond the platform's baseline that both the processor and the operating system support.
struct ProcessorFeatures {
	bool avx2 = false;
	bool fma = false;
};

// Of the machine that runs this; false on processors other than x86-64.
[[nodiscard]] const ProcessorFeatures &processor_features() noexcept;

} // namespace cga
