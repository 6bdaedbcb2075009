#pragma once

#include "cga/batch/instruction_set.hpp"
#include "cga/batch/motor_block.hpp"
#include "cga/batch/pose_block.hpp"

namespace cga::kernel {

// The batch operations of one instruction set. motor_block.hpp and pose_block.hpp say what each does.
//
// One source, kernels.inl, is compiled once for each set, by kernels_<set>.cpp with the compiler's options for that set
// (SConstruct and CMakeLists.txt choose them by the file's name). There, everything but the table has internal linkage and
// nothing calls an inline function of another header: otherwise the linker could keep a copy compiled for AVX2 for the whole
// program, which then fails on older processors. A test checks the symbols of the object files (tests/package).
struct Kernels {
	void (*interpolate_blocks)(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows) noexcept;
	void (*compose_blocks)(const MotorBlock *first, const MotorBlock *second, size_t block_count, MotorBlock *products) noexcept;
	// images = linear * points + offset, `matrix` being a row of ROW_FLOATS.
	void (*transform_by_matrix)(const float *matrix, const float *points, size_t count, float *images) noexcept;
	void (*transform_points)(const MotorBlock *motors, const float *points, size_t count, float *images) noexcept;
	void (*extract_blocks)(const MotorBlock *motors, size_t body_count, float *rows) noexcept;
	void (*motors_from_rows)(const float *rows, size_t body_count, MotorBlock *motors) noexcept;
};

extern const Kernels SCALAR_KERNELS;
extern const Kernels BASELINE_KERNELS;
extern const Kernels AVX2_FMA_KERNELS; // defined on x86-64 only

// The kernels of `set`, or those of BASELINE if this machine does not support it.
[[nodiscard]] const Kernels &kernels_of(InstructionSet set) noexcept;

} // namespace cga::kernel
