#include "cga/batch/motor_block.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <limits>
#include <vector>

using namespace cga;
using namespace cga_test;

// The scalar kernels are compiled from the same source: only vectorized code can be twice as fast. The bound is far below the
// measured ratios (3 to 9). Times are the minimum of many runs, which alternate so that load on the machine affects both.

namespace {

constexpr size_t BLOCKS = 64;
constexpr size_t BODIES = BLOCKS * size_t(PoseBlock::LANES);

struct Work {
	std::vector<PoseBlock> poses = std::vector<PoseBlock>(BLOCKS);
	std::vector<MotorBlock> motors = std::vector<MotorBlock>(BLOCKS);
	std::vector<MotorBlock> products = std::vector<MotorBlock>(BLOCKS);
	std::vector<float> rows = std::vector<float>(BODIES * ROW_FLOATS);
	std::vector<float> points = std::vector<float>(BODIES * 3, 1.0f);

	Work() {
		Random random(91);
		for (size_t i = 0; i < BODIES; ++i) {
			const Pose<float> from = pose_cast<float>(random.pose());
			poses[i / 8].set(int(i % 8), from, pose_cast<float>(random.pose()));
			motors[i / 8].set(int(i % 8), Motor<float>::from_pose(from));
		}
	}
};

template <class Run>
double seconds(const Run &run, InstructionSet set) {
	const auto start = std::chrono::steady_clock::now();
	run(set);
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The time of the scalar kernels divided by that of `set`.
template <class Run>
double speedup(const Run &run, InstructionSet set) {
	double scalar = std::numeric_limits<double>::infinity();
	double vector = scalar;
	for (int turn = 0; turn < 200; ++turn) {
		scalar = std::min(scalar, seconds(run, InstructionSet::SCALAR));
		vector = std::min(vector, seconds(run, set));
	}
	return scalar / vector;
}

} // namespace

#if !defined(SANITIZED) && !defined(__clang__)
TEST_CASE("kernels are vectorized: at least twice as fast as the scalar ones") {
	constexpr double BOUND = 2.0;
	Work work;
	const auto interpolation = [&work](Mode mode) {
		return [&work, mode](InstructionSet set) {
			interpolate_blocks(work.poses.data(), BODIES, nullptr, 0.3f, mode, work.rows.data(), set);
		};
	};
	for (const InstructionSet set : { InstructionSet::BASELINE, best_instruction_set() }) {
		CAPTURE(int(set));
		CHECK(speedup(interpolation(Mode::LINEAR), set) > BOUND);
		CHECK(speedup(interpolation(Mode::SCREW), set) > BOUND);
		CHECK(speedup(interpolation(Mode::SEPARATE), set) > BOUND);
		CHECK(speedup([&work](InstructionSet any) { compose_blocks(work.motors.data(), work.motors.data(), BLOCKS, work.products.data(), any); }, set) > BOUND);
		CHECK(speedup([&work](InstructionSet any) { extract_blocks(work.motors.data(), BODIES, work.rows.data(), any); }, set) > BOUND);
		CHECK(speedup([&work](InstructionSet any) { motors_from_rows(work.rows.data(), BODIES, work.products.data(), any); }, set) > BOUND);
		CHECK(speedup([&work](InstructionSet any) { transform_points(work.motors.data(), work.points.data(), BODIES, work.points.data(), any); }, set) > BOUND);
	}
}
#endif
