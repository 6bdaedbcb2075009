#pragma once

// Marks a function that is always inlined: kernels that become one loop, or straight code, only as a whole.
#if defined(__GNUC__)
#define CGA_FLATTEN inline __attribute__((always_inline))
#else
#define CGA_FLATTEN __forceinline
#endif

// Before a loop over lanes: what one of them writes, no other reads, even where output and input are the same memory.
#if defined(__clang__)
#define CGA_LANES_APART _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define CGA_LANES_APART _Pragma("GCC ivdep")
#else
#define CGA_LANES_APART
#endif
