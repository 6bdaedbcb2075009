#include "cga/platform/processor.hpp"

#include "cga/platform/compiler.hpp"

#include <doctest/doctest.h>

using namespace cga;

#if CGA_X86_64 && defined(__GLIBC__)
TEST_CASE("the processor's features are those that the C library's compiler runtime reports") {
	CHECK(processor_features().avx2 == (__builtin_cpu_supports("avx2") != 0));
	CHECK(processor_features().fma == (__builtin_cpu_supports("fma") != 0));
}
#endif

#if !CGA_X86_64
TEST_CASE("processors other than x86-64 have none of its features") {
	CHECK_FALSE(processor_features().avx2);
	CHECK_FALSE(processor_features().fma);
}
#endif
