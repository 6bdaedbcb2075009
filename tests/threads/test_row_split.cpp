#include "godot/motion/row_split.hpp"

#include "cga/batch/pose_block.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <vector>

// What MotorPool does in the threads of the engine's pool. tools/test --sanitize runs it with the thread sanitizer.

namespace {

using ga_godot::RowSplit;

constexpr uint32_t ROWS = 5 * RowSplit::ROWS_PER_PIECE + 77;

cga::Pose<float> pose_of(uint32_t row) {
	cga::Pose<float> pose;
	pose.translation = { float(row), 1.0f, -float(row) };
	return pose;
}

} // namespace

TEST_CASE("row split: each row is done once, by whatever thread") {
	std::vector<int> times(ROWS);
	std::atomic<uint32_t> pieces = 0;
	RowSplit::run(ROWS, 1, [&](uint32_t first, uint32_t count) {
		CHECK_MESSAGE(first % RowSplit::ROWS_PER_PIECE == 0, first);
		++pieces;
		for (uint32_t row = first; row < first + count; ++row) {
			++times[row];
		}
	});
	CHECK(pieces == 6);
	CHECK(times == std::vector<int>(ROWS, 1));
}

TEST_CASE("row split: threads set and interpolate the poses of one pool") {
	std::vector<cga::PoseBlock> blocks(cga::block_count(ROWS));
	std::vector<float> shared(size_t(ROWS) * cga::ROW_FLOATS);
	std::vector<float> alone(shared.size());
	for (int frame = 0; frame < 3; ++frame) {
		RowSplit::run(ROWS, 1, [&](uint32_t first, uint32_t count) {
			for (uint32_t row = first; row < first + count; ++row) {
				blocks[row / cga::PoseBlock::LANES].set_to(int(row % cga::PoseBlock::LANES), pose_of(row + uint32_t(frame)));
			}
		});
		RowSplit::run(ROWS, 1, [&](uint32_t first, uint32_t count) {
			cga::interpolate_blocks(blocks.data() + first / cga::PoseBlock::LANES, count, nullptr, 0.5f, cga::Mode::SCREW, shared.data() + size_t(first) * cga::ROW_FLOATS);
		});
	}
	cga::interpolate_blocks(blocks.data(), ROWS, nullptr, 0.5f, cga::Mode::SCREW, alone.data());
	CHECK(shared == alone);
}
