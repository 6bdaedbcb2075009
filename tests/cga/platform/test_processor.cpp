#include "cga/platform/processor.hpp"

#include "cga/platform/compiler.hpp"

#include <doctest/doctest.h>

using namespace cga;

#if CGA_X86_64 && defined(__GLIBC__)
TEST_CASE("the detected features agree with the compiler's runtime") {
	CHECK(processor_features().avx2 == (__builtin_cpu_supports("avx2") != 0));
	CHECK(processor_features().fma == (__builtin_cpu_supports("fma") != 0));
}
#endif

#if !CGA_X86_64
TEST_CASE("other processors than x86-64 report no features") {
	CHECK_FALSE(processor_features().avx2);
	CHECK_FALSE(processor_features().fma);
}
#endif
