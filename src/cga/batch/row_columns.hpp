#pragma once

#include "cga/batch/pose_block.hpp"
#include "cga/platform/compiler.hpp"

// Kernels compute the 12 floats of a row for 8 bodies at a time, as columns. A row transpose, one for each instruction set,
// turns these into 8 rows and back:
//
//   void write_rows(const RowColumns &columns, float *rows)
//   void read_rows(const float *rows, RowColumns &columns)
//
// `columns` have the alignment of a PoseBlock. Compilers do not turn such loops into shuffles, hence the intrinsics.

namespace cga::kernel {

using RowColumns = PoseBlock::Row[ROW_FLOATS];

constexpr size_t BLOCK_LANES = size_t(PoseBlock::LANES);

} // namespace cga::kernel
