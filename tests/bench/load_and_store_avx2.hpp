#pragma once

#include "cga/batch/pose_block.hpp"

namespace kernels_bench {

// Reads and writes the bytes that a linear blend does, in the same places and as wide, and computes nothing. On x86-64 only.
void load_and_store(const cga::PoseBlock *blocks, size_t block_count, float *rows) noexcept;

} // namespace kernels_bench
