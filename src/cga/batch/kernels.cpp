#include "cga/batch/kernels.hpp"

#include "cga/platform/compiler.hpp"
#include "cga/platform/processor.hpp"

namespace cga {

InstructionSet best_instruction_set() noexcept {
	static const bool HAS_AVX2_FMA = processor_features().avx2 && processor_features().fma;
	return HAS_AVX2_FMA ? InstructionSet::AVX2_FMA : InstructionSet::BASELINE;
}

const kernel::Kernels &kernel::kernels_of(InstructionSet set) noexcept {
#if CGA_X86_64
	if (set == InstructionSet::AVX2_FMA && best_instruction_set() == set) {
		return AVX2_FMA_KERNELS;
	}
#endif
	return set == InstructionSet::SCALAR ? SCALAR_KERNELS : BASELINE_KERNELS;
}

void interpolate_blocks(const PoseBlock *blocks, size_t body_count, const float *weights, float weight, Mode mode, float *rows, InstructionSet set) noexcept {
	kernel::kernels_of(set).interpolate_blocks(blocks, body_count, weights, weight, mode, rows);
}

void compose_blocks(const MotorBlock *first, const MotorBlock *second, size_t block_count, MotorBlock *products, InstructionSet set) noexcept {
	kernel::kernels_of(set).compose_blocks(first, second, block_count, products);
}

void transform_points(const Motor<float> &motor, const float *points, size_t count, float *images, InstructionSet set) noexcept {
	MotorBlock block;
	block.set(0, motor);
	float matrix[ROW_FLOATS];
	kernel::SCALAR_KERNELS.extract_blocks(&block, 1, matrix);
	kernel::kernels_of(set).transform_by_matrix(matrix, points, count, images);
}

void transform_points(const MotorBlock *motors, const float *points, size_t count, float *images, InstructionSet set) noexcept {
	kernel::kernels_of(set).transform_points(motors, points, count, images);
}

void extract_blocks(const MotorBlock *motors, size_t body_count, float *rows, InstructionSet set) noexcept {
	kernel::kernels_of(set).extract_blocks(motors, body_count, rows);
}

void motors_from_rows(const float *rows, size_t body_count, MotorBlock *motors, InstructionSet set) noexcept {
	kernel::kernels_of(set).motors_from_rows(rows, body_count, motors);
}

} // namespace cga
