#include "cga/batch/pose_block.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <vector>

using namespace cga;
using namespace cga_test;

namespace {

constexpr Mode MODES[] = { Mode::LINEAR, Mode::SCREW, Mode::SEPARATE };

struct Bodies {
	std::vector<Pose<float>> from;
	std::vector<Pose<float>> to;
	std::vector<PoseBlock> blocks;

	void add(const Pose<float> &first, const Pose<float> &second) {
		const size_t body = from.size();
		from.push_back(first);
		to.push_back(second);
		blocks.resize(block_count(from.size()));
		blocks[body / PoseBlock::LANES].set(int(body % PoseBlock::LANES), first, second);
	}
};

Bodies random_bodies(unsigned seed, size_t count, double distance) {
	Random random(seed);
	Bodies bodies;
	for (size_t body = 0; body < count; ++body) {
		PoseD from = random.pose(10.0);
		PoseD to = random.pose(10.0);
		const Vector3D where = random.vector(1.0) * distance;
		from.translation += where;
		to.translation += where;
		bodies.add(pose_cast<float>(from), pose_cast<float>(to));
	}
	return bodies;
}

// The largest error of a row: of the basis relative to its scale, of the origin in meters relative to `size`.
double row_error(const float *row, const PoseD &expected, double size) {
	const glm::dmat3 basis = glm::mat3_cast(expected.rotation);
	double worst = 0.0;
	for (int axis = 0; axis < 3; ++axis) {
		for (int column = 0; column < 3; ++column) {
			worst = std::max(worst, std::abs(double(row[4 * axis + column]) / expected.scale - basis[column][axis]));
		}
		worst = std::max(worst, std::abs(double(row[4 * axis + 3]) - expected.translation[axis]) / size);
	}
	return worst;
}

double worst_error(const Bodies &bodies, const std::vector<float> &rows, const std::vector<float> &weights, Mode mode, double size) {
	double worst = 0.0;
	for (size_t body = 0; body < bodies.from.size(); ++body) {
		const PoseD from = pose_cast<double>(bodies.from[body]);
		const PoseD to = pose_cast<double>(bodies.to[body]);
		const PoseD expected = interpolate(from, to, double(weights[body]), mode);
		const double reach = std::max({ 1.0, glm::length(expected.translation), glm::length(to.translation - from.translation) });
		worst = std::max(worst, row_error(&rows[body * ROW_FLOATS], expected, size > 0.0 ? size : reach));
	}
	return worst;
}

} // namespace

TEST_CASE("blocks of bodies agree with one pose at a time, to 1e-5") {
	const Bodies bodies = random_bodies(51, 5000, 0.0);
	std::vector<float> rows(bodies.from.size() * ROW_FLOATS);
	for (const Mode mode : MODES) {
		for (const float weight : { 0.0f, 1e-6f, 0.1f, 0.5f, 0.9f, 1.0f }) {
			interpolate_blocks(bodies.blocks.data(), bodies.from.size(), nullptr, weight, mode, rows.data());
			const std::vector<float> weights(bodies.from.size(), weight);
			CAPTURE(int(mode));
			CAPTURE(weight);
			CHECK(worst_error(bodies, rows, weights, mode, 0.0) < 1e-5);
		}
	}
}

TEST_CASE("one weight for each body, also outside 0..1") {
	const Bodies bodies = random_bodies(52, 1003, 0.0);
	Random random(53);
	std::vector<float> weights;
	weights.reserve(bodies.from.size());
	for (size_t body = 0; body < bodies.from.size(); ++body) {
		weights.push_back(float(random.uniform(-0.25, 1.25)));
	}
	std::vector<float> rows(bodies.from.size() * ROW_FLOATS + 1, -123.0f);
	for (const Mode mode : MODES) {
		interpolate_blocks(bodies.blocks.data(), bodies.from.size(), weights.data(), 99.0f, mode, rows.data());
		CHECK(worst_error(bodies, rows, weights, mode, 0.0) < 2e-5);
		CHECK(rows.back() == -123.0f); // the last, partial block did not write beyond its bodies
	}
}

TEST_CASE("ten kilometers from the origin, within float's rounding of a millimeter") {
	const Bodies bodies = random_bodies(54, 2000, 1e4);
	std::vector<float> rows(bodies.from.size() * ROW_FLOATS);
	const std::vector<float> weights(bodies.from.size(), 0.37f);
	for (const Mode mode : MODES) {
		interpolate_blocks(bodies.blocks.data(), bodies.from.size(), nullptr, 0.37f, mode, rows.data());
		const double meter = 1.0;
		// Up to 40 km here, where float's steps are 4 mm; rounding once is half a step.
		CHECK(worst_error(bodies, rows, weights, mode, meter) < 2.1e-3);
	}
}

TEST_CASE("degenerate poses: identity, rotations by pi, q and -q, no translation, scales 0.01 and 100, tiny angles") {
	const Quaternion<float> rotations[] = { { 1, 0, 0, 0 }, { -1, 0, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, -1 }, { 1, 1e-7f, 0, 0 }, { 1, 1e-20f, 0, 0 }, { 1, 0, 1e-38f, 0 }, { 0.6f, 0.8f, 0, 0 } };
	const Vector3<float> translations[] = { { 0, 0, 0 }, { 1, 2, 3 }, { 1e-20f, 0, 0 } };
	Bodies bodies;
	for (const auto &first_rotation : rotations) {
		for (const auto &second_rotation : rotations) {
			for (const auto &translation : translations) {
				for (const float scale : { 1.0f, 1.00000012f, 1.001f, 0.01f, 100.0f }) {
					bodies.add({ { 0, 1, 0 }, first_rotation, 1.0f }, { translation, second_rotation, scale });
				}
			}
		}
	}
	std::vector<float> rows(bodies.from.size() * ROW_FLOATS);
	for (const Mode mode : MODES) {
		for (const float weight : { 0.0f, 0.3f, 0.5f, 1.0f }) {
			interpolate_blocks(bodies.blocks.data(), bodies.from.size(), nullptr, weight, mode, rows.data());
			CAPTURE(int(mode));
			CAPTURE(weight);
			CHECK(worst_error(bodies, rows, std::vector<float>(bodies.from.size(), weight), mode, 0.0) < 1e-5);
		}
	}
	CHECK(bodies.from.size() == 960);
}

TEST_CASE("finite input gives finite rows") {
	const float largest = std::numeric_limits<float>::max();
	const float denormal = std::numeric_limits<float>::denorm_min();
	Bodies bodies;
	for (const float length : { 0.0f, 1e30f, -largest, denormal }) {
		for (const float other : { 1e30f, largest, 1.0f }) {
			for (const float scale : { 1.0f, denormal, 1e30f, 0.0f, -2.0f }) {
				for (const Quaternion<float> &rotation : { Quaternion<float>(1, 0, 0, 0), Quaternion<float>(0, 1, 0, 0), Quaternion<float>(0, 0, 0, 0), Quaternion<float>(1, denormal, -largest, 0), Quaternion<float>(-1, 1, 1, 1) }) {
					bodies.add({ { length, 0, other }, { 1, 0, 0, 0 }, 1.0f }, { { other, length, length }, rotation, scale });
					bodies.add({ { length, 0, other }, rotation, scale }, { { other, length, length }, { 1, 0, 0, 0 }, 1.0f });
				}
			}
		}
	}
	std::vector<float> rows(bodies.from.size() * ROW_FLOATS);
	int bad = 0;
	for (const Mode mode : MODES) {
		for (const float weight : { 0.0f, 0.5f, 1.0f, -0.5f, 3.0f, 1e6f, -largest, largest }) {
			interpolate_blocks(bodies.blocks.data(), bodies.from.size(), nullptr, weight, mode, rows.data());
			for (const float entry : rows) {
				bad += std::isfinite(entry) ? 0 : 1;
			}
		}
	}
	CHECK(bodies.from.size() == 600);
	CHECK(bad == 0);
}

TEST_CASE("scalar and baseline instructions give the same bits, the machine's best the same to 1e-6") {
	const Bodies bodies = random_bodies(57, 1001, 0.0);
	const size_t count = bodies.from.size();
	std::vector<float> scalar(count * ROW_FLOATS);
	std::vector<float> baseline(scalar.size());
	std::vector<float> best(scalar.size());
	for (const Mode mode : MODES) {
		for (const float weight : { 0.0f, 0.25f, 0.61f, 1.0f }) {
			interpolate_blocks(bodies.blocks.data(), count, nullptr, weight, mode, scalar.data(), InstructionSet::SCALAR);
			interpolate_blocks(bodies.blocks.data(), count, nullptr, weight, mode, baseline.data(), InstructionSet::BASELINE);
			interpolate_blocks(bodies.blocks.data(), count, nullptr, weight, mode, best.data());
			CHECK(std::memcmp(scalar.data(), baseline.data(), scalar.size() * sizeof(float)) == 0);
			float worst = 0.0f;
			for (size_t body = 0; body < count; ++body) {
				const float reach = std::max(1.0f, glm::length(bodies.to[body].translation - bodies.from[body].translation));
				const float scale = std::max({ 1.0f, bodies.from[body].scale, bodies.to[body].scale });
				for (size_t entry = body * ROW_FLOATS; entry < (body + 1) * ROW_FLOATS; ++entry) {
					worst = std::max(worst, std::abs(best[entry] - scalar[entry]) / (entry % 4 == 3 ? reach : scale));
				}
			}
			CAPTURE(int(mode));
			CHECK(worst < 1e-6f);
		}
	}
}

TEST_CASE("the result does not depend on the lane or on how the work is split, bit for bit") {
	const Bodies bodies = random_bodies(55, 1001, 100.0);
	const size_t count = bodies.from.size();
	std::vector<float> rows(count * ROW_FLOATS);
	std::vector<float> others(count * ROW_FLOATS);
	for (const Mode mode : MODES) {
		interpolate_blocks(bodies.blocks.data(), count, nullptr, 0.61f, mode, rows.data());
		const size_t first_blocks = 40;
		const size_t first_bodies = first_blocks * PoseBlock::LANES;
		std::fill(others.begin(), others.end(), 0.0f);
		interpolate_blocks(bodies.blocks.data(), first_bodies, nullptr, 0.61f, mode, others.data());
		interpolate_blocks(bodies.blocks.data() + first_blocks, count - first_bodies, nullptr, 0.61f, mode, others.data() + first_bodies * ROW_FLOATS);
		CHECK(std::memcmp(rows.data(), others.data(), rows.size() * sizeof(float)) == 0);

		Bodies shifted;
		for (size_t body = 3; body < count; ++body) {
			shifted.add(bodies.from[body], bodies.to[body]);
		}
		interpolate_blocks(shifted.blocks.data(), count - 3, nullptr, 0.61f, mode, others.data());
		CHECK(std::memcmp(rows.data() + 3 * ROW_FLOATS, others.data(), (count - 3) * ROW_FLOATS * sizeof(float)) == 0);
	}
}

TEST_CASE("get returns what was set, and setting one end keeps the other") {
	Random random(56);
	PoseBlock block;
	CHECK(block.get_from(7).rotation == Quaternion<float>(1, 0, 0, 0));
	CHECK(block.get_to(0).scale == 1.0f);
	for (int repeat = 0; repeat < 200; ++repeat) {
		const int lane = repeat % PoseBlock::LANES;
		const Pose<float> from = pose_cast<float>(random.pose(1e4));
		const Pose<float> to = pose_cast<float>(random.pose(1e4));
		block.set_from(lane, from);
		block.set_to(lane, to);
		PoseBlock at_once;
		at_once.set(lane, from, to);
		CHECK(block.get_from(lane).translation == from.translation);
		CHECK(block.get_from(lane).rotation == from.rotation);
		CHECK(block.get_from(lane).scale == from.scale);
		CHECK(block.get_to(lane).translation == to.translation);
		CHECK(block.get_to(lane).rotation == to.rotation);
		CHECK(block.get_to(lane).scale == to.scale);
		CHECK(block.axis[2][lane] == at_once.axis[2][lane]);
		CHECK(block.curvature[1][lane] == at_once.curvature[1][lane]);
		CHECK(block.across[1][lane] == at_once.across[1][lane]);
		CHECK(block.shortening[lane] <= 2.0f);
	}
}

TEST_CASE("zero bodies write nothing; block_count() rounds up") {
	interpolate_blocks(nullptr, 0, nullptr, 0.5f, Mode::SCREW, nullptr);
	CHECK(block_count(0) == 0);
	CHECK(block_count(1) == 1);
	CHECK(block_count(8) == 1);
	CHECK(block_count(9) == 2);
}

TEST_CASE("blocks keep the second rotation as it was set, up to its sign") {
	Random random(58);
	for (int repeat = 0; repeat < 100; ++repeat) {
		PoseBlock block;
		const Pose<float> to = pose_cast<float>(random.pose(10.0));
		block.set(0, pose_cast<float>(random.pose(10.0)), to);
		for (int axis = 0; axis < 4; ++axis) {
			CHECK(block.to_rotation[axis][0] * block.hemisphere[0] == to.rotation[axis == 0 ? 3 : axis - 1]);
		}
	}
}
