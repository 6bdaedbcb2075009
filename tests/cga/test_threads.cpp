#include "../harness/threads.hpp"
#include "cga/algebra/multivector.hpp"
#include "cga/batch/pose_block.hpp"
#include "cga/motor/interpolate.hpp"
#include "cga/object/classify.hpp"
#include "cga/text/text.hpp"
#include "cga/versor/logarithm.hpp"
#include "random_poses.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

// What the documentation calls free of shared state, in several threads at once; with the thread sanitizer, races fail.

using namespace cga;
using cga_test::Random;

static constexpr size_t THREADS = 4;

TEST_CASE("threads: const operations on shared multivectors") {
	const Multivector left = Random(1).multivector();
	const Multivector right = Random(2).multivector();
	const auto work = [&](size_t) {
		std::string text;
		for (int i = 0; i < 50; ++i) {
			const Multivector product = left.geometric_product(right).outer_product(left.dual()) + right.inner_product(left);
			text += to_text(product);
			text += to_text(left.regressive_product(right));
			text += std::to_string(int(classify(product, false).kind));
		}
		return text;
	};
	const std::string expected = work(0);
	for (const std::string &result : harness::run_in_threads(THREADS, work)) {
		CHECK(result == expected);
	}
}

TEST_CASE("threads: each with its own blocks of poses") {
	const auto work = [](size_t seed) {
		Random random{ unsigned(seed) };
		std::vector<PoseBlock> blocks(block_count(100));
		for (size_t body = 0; body < 100; ++body) {
			blocks[body / PoseBlock::LANES].set(int(body % PoseBlock::LANES), pose_cast<float>(random.pose()), pose_cast<float>(random.pose()));
		}
		std::vector<float> rows(100 * ROW_FLOATS);
		for (const Mode mode : { Mode::LINEAR, Mode::SCREW, Mode::SEPARATE }) {
			interpolate_blocks(blocks.data(), 100, nullptr, 0.3f, mode, rows.data());
		}
		return rows;
	};
	const std::vector<std::vector<float>> results = harness::run_in_threads(THREADS, work);
	for (size_t i = 0; i < THREADS; ++i) {
		CHECK(results[i] == work(i));
	}
}

TEST_CASE("threads: parts of one array of blocks") {
	constexpr size_t BODIES = size_t(8) * PoseBlock::LANES;
	Random random(5);
	std::vector<PoseBlock> blocks(block_count(THREADS * BODIES));
	for (size_t body = 0; body < THREADS * BODIES; ++body) {
		blocks[body / PoseBlock::LANES].set(int(body % PoseBlock::LANES), pose_cast<float>(random.pose()), pose_cast<float>(random.pose()));
	}
	std::vector<float> rows(THREADS * BODIES * ROW_FLOATS);
	harness::run_in_threads(THREADS, [&](size_t part) {
		interpolate_blocks(blocks.data() + part * BODIES / PoseBlock::LANES, BODIES, nullptr, 0.3f, Mode::SCREW, rows.data() + part * BODIES * ROW_FLOATS);
		return part;
	});
	std::vector<float> expected(rows.size());
	interpolate_blocks(blocks.data(), THREADS * BODIES, nullptr, 0.3f, Mode::SCREW, expected.data());
	CHECK(rows == expected);
}
