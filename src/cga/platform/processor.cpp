#include "cga/platform/processor.hpp"

#include "cga/platform/compiler.hpp"

#include <cstdint>

#if CGA_X86_64
#if defined(_MSC_VER)
#include <intrin.h>
#else
#include <cpuid.h>
#endif
#endif

// Reads CPUID itself: the compilers' __builtin_cpu_supports() needs start-up code that some toolchains, such as zig, lack.

namespace cga {

namespace {

#if CGA_X86_64

struct Registers {
	uint32_t eax = 0, ebx = 0, ecx = 0, edx = 0;
};

Registers cpuid(uint32_t leaf) noexcept {
	Registers registers;
#if defined(_MSC_VER)
	int values[4];
	__cpuidex(values, int(leaf), 0);
	registers = { uint32_t(values[0]), uint32_t(values[1]), uint32_t(values[2]), uint32_t(values[3]) };
#else
	__cpuid_count(leaf, 0, registers.eax, registers.ebx, registers.ecx, registers.edx);
#endif
	return registers;
}

// XCR0: the registers that the operating system saves.
uint64_t saved_registers() noexcept {
#if defined(_MSC_VER)
	return _xgetbv(0);
#else
	uint32_t low, high;
	__asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
	return (uint64_t(high) << 32) | low;
#endif
}

constexpr bool has_bit(uint64_t value, int bit) noexcept {
	return ((value >> bit) & 1) != 0;
}

ProcessorFeatures detect() noexcept {
	constexpr int FMA = 12, OSXSAVE = 27, AVX = 28; // ECX of leaf 1
	constexpr int AVX2 = 5; // EBX of leaf 7
	constexpr int XMM = 1, YMM = 2; // XCR0
	if (cpuid(0).eax < 7) {
		return {};
	}
	const Registers leaf_1 = cpuid(1);
	if (!has_bit(leaf_1.ecx, OSXSAVE) || !has_bit(leaf_1.ecx, AVX)) {
		return {};
	}
	const uint64_t saved = saved_registers();
	if (!has_bit(saved, XMM) || !has_bit(saved, YMM)) {
		return {};
	}
	return { has_bit(cpuid(7).ebx, AVX2), has_bit(leaf_1.ecx, FMA) };
}

#else

ProcessorFeatures detect() noexcept {
	return {};
}

#endif

} // namespace

const ProcessorFeatures &processor_features() noexcept {
	static const ProcessorFeatures FEATURES = detect();
	return FEATURES;
}

} // namespace cga
