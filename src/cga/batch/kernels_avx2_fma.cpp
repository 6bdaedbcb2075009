#include "cga/platform/compiler.hpp"

#if CGA_X86_64

#include "cga/batch/row_transpose_avx2.hpp"

#include "cga/batch/kernels.inl"

const cga::kernel::Kernels cga::kernel::AVX2_FMA_KERNELS = KERNELS;

#endif
