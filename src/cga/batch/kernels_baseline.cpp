#include "cga/batch/row_transpose_baseline.hpp"

#include "cga/batch/kernels.inl"

const cga::kernel::Kernels cga::kernel::BASELINE_KERNELS = KERNELS;
