#pragma once

// The only file with attributes and pragmas of particular compilers and with their macros for processors and libraries.

#include <charconv>

// Whether <charconv> converts doubles. libc++ does since version 20, but does not define the macro, as long double is missing;
// Apple's refuses it to programs for older systems.
#if defined(__cpp_lib_to_chars)
#define CGA_HAS_CHARCONV 1
#elif defined(_LIBCPP_VERSION) && !_LIBCPP_HAS_VENDOR_AVAILABILITY_ANNOTATIONS
#define CGA_HAS_CHARCONV (_LIBCPP_VERSION >= 200000)
#else
#define CGA_HAS_CHARCONV 0
#endif

// CGA_BASELINE_ONLY, for tests: no code beyond the processor's baseline.
#if (defined(__x86_64__) || defined(_M_X64)) && !defined(CGA_BASELINE_ONLY)
#define CGA_X86_64 1
#elif defined(__aarch64__) || defined(_M_ARM64)
#define CGA_ARM64 1
#endif

// Forces inlining, for kernels that vectorize or become straight-line code only if all their functions are inlined.
#if defined(_MSC_VER) && !defined(__clang__)
#define CGA_ALWAYS_INLINE __forceinline
#else
#define CGA_ALWAYS_INLINE inline __attribute__((always_inline))
#endif

// Before a loop: its iterations are independent, even where input and output are the same memory.
#if defined(__clang__)
#define CGA_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#elif defined(_MSC_VER)
#define CGA_INDEPENDENT_ITERATIONS __pragma(loop(ivdep))
#else
#define CGA_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#endif
