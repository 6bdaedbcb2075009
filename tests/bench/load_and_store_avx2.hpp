#pragma once

#include "cga/batch/pose_block.hpp"

namespace kernels_bench {

// Reads and writes the same bytes as a linear blend, with the same addresses and widths, and computes nothing. x86-64 only.
void load_and_store(const cga::PoseBlock *blocks, size_t block_count, float *rows) noexcept;

} // namespace kernels_bench
