#pragma once

// Marks a function that is always inlined: kernels that become one loop, or straight code, only as a whole.
#if defined(__GNUC__)
#define CGA_FLATTEN inline __attribute__((always_inline))
#else
#define CGA_FLATTEN __forceinline
#endif
