#include "cga/batch/row_transpose_scalar.hpp"

#include "cga/batch/kernels.inl"

const cga::kernel::Kernels cga::kernel::SCALAR_KERNELS = KERNELS;
