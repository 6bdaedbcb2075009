#include "cga/batch/motor_block.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

using namespace cga;
using namespace cga_test;

namespace {

constexpr InstructionSet SETS[] = { InstructionSet::SCALAR, InstructionSet::BASELINE, InstructionSet::AVX2_FMA };
constexpr size_t COUNT = 1003; // a last block of 3
constexpr double TOLERANCE = 1e-6;

struct Motors {
	std::vector<Motor<float>> each;
	std::vector<MotorBlock> blocks;

	void add(const Motor<float> &motor) {
		blocks.resize(block_count(each.size() + 1));
		blocks[each.size() / 8].set(int(each.size() % 8), motor);
		each.push_back(motor);
	}
};

// Motors of any weight, half of them negative.
Motors random_motors(unsigned seed) {
	Random random(seed);
	Motors motors;
	for (size_t i = 0; i < COUNT; ++i) {
		Motor<float> motor = Motor<float>::from_pose(pose_cast<float>(random.pose(10.0)));
		const float weight = float(random.uniform(0.5, 2.0)) * (i % 2 == 0 ? 1.0f : -1.0f);
		motor.a *= weight;
		motor.b *= weight;
		motor.v *= weight;
		motors.add(motor);
	}
	return motors;
}

Motor<double> in_double(const Motor<float> &motor) {
	return { Quaternion<double>(motor.a), Quaternion<double>(motor.b), Quaternion<double>(motor.v) };
}

double length(const Quaternion<double> &q) {
	return std::sqrt(glm::dot(q, q));
}

std::vector<float> random_points(unsigned seed) {
	Random random(seed);
	std::vector<float> points;
	for (size_t i = 0; i < COUNT; ++i) {
		const Vector3D point = random.vector(10.0);
		points.insert(points.end(), { float(point.x), float(point.y), float(point.z) });
	}
	return points;
}

Vector3D point_at(const std::vector<float> &points, size_t i) {
	return { points[3 * i], points[3 * i + 1], points[3 * i + 2] };
}

} // namespace

TEST_CASE("blocks of motors compose like single motors, also in place") {
	const Motors first = random_motors(71);
	const Motors second = random_motors(72);
	for (const InstructionSet set : SETS) {
		std::vector<MotorBlock> products(first.blocks.size());
		compose_blocks(first.blocks.data(), second.blocks.data(), products.size(), products.data(), set);
		double worst = 0.0;
		for (size_t i = 0; i < COUNT; ++i) {
			const Motor<double> expected = compose(in_double(first.each[i]), in_double(second.each[i]));
			const Motor<double> product = in_double(products[i / 8].get(int(i % 8)));
			const double size = length(in_double(first.each[i]).b) * length(in_double(second.each[i]).v) + length(in_double(first.each[i]).v) * length(in_double(second.each[i]).a);
			worst = std::max(worst, length(product.a - expected.a) / length(expected.a));
			worst = std::max(worst, length(product.b - expected.b) / length(expected.b));
			worst = std::max(worst, length(product.v - expected.v) / size);
		}
		CAPTURE(int(set));
		CHECK(worst < TOLERANCE);

		std::vector<MotorBlock> left = first.blocks;
		compose_blocks(left.data(), second.blocks.data(), left.size(), left.data(), set);
		std::vector<MotorBlock> right = second.blocks;
		compose_blocks(first.blocks.data(), right.data(), right.size(), right.data(), set);
		const size_t bytes = products.size() * sizeof(MotorBlock);
		CHECK(std::memcmp(left.data(), products.data(), bytes) == 0);
		CHECK(std::memcmp(right.data(), products.data(), bytes) == 0);
	}
}

TEST_CASE("one motor transforms many points, and many motors one point each, also in place") {
	const Motors motors = random_motors(73);
	const std::vector<float> points = random_points(74);
	for (const InstructionSet set : SETS) {
		CAPTURE(int(set));
		std::vector<float> images(points.size() + 1, -5.0f);
		transform_points(motors.each[7], points.data(), COUNT, images.data(), set);
		double worst = 0.0;
		for (size_t i = 0; i < COUNT; ++i) {
			const Vector3D expected = in_double(motors.each[7]).transform_point(point_at(points, i));
			worst = std::max(worst, glm::length(point_at(images, i) - expected) / std::max(10.0, glm::length(expected)));
		}
		CHECK(worst < TOLERANCE);

		std::vector<float> own_images(points.size() + 1, -5.0f);
		transform_points(motors.blocks.data(), points.data(), COUNT, own_images.data(), set);
		worst = 0.0;
		for (size_t i = 0; i < COUNT; ++i) {
			const Vector3D expected = in_double(motors.each[i]).transform_point(point_at(points, i));
			worst = std::max(worst, glm::length(point_at(own_images, i) - expected) / std::max(20.0, glm::length(expected)));
		}
		CHECK(worst < TOLERANCE);

		for (const bool is_one : { true, false }) {
			std::vector<float> in_place = points;
			if (is_one) {
				transform_points(motors.each[7], in_place.data(), COUNT, in_place.data(), set);
			} else {
				transform_points(motors.blocks.data(), in_place.data(), COUNT, in_place.data(), set);
			}
			CHECK(std::memcmp(in_place.data(), (is_one ? images : own_images).data(), in_place.size() * sizeof(float)) == 0);
		}
		CHECK(images.back() == -5.0f);
		CHECK(own_images.back() == -5.0f);
	}
}

TEST_CASE("motors of any weight give the rows of their poses, and rows give the motors of unit weight") {
	const Motors motors = random_motors(75);
	for (const InstructionSet set : SETS) {
		CAPTURE(int(set));
		std::vector<float> rows(COUNT * ROW_FLOATS + 1, -5.0f);
		extract_blocks(motors.blocks.data(), COUNT, rows.data(), set);
		CHECK(rows.back() == -5.0f);
		std::vector<MotorBlock> again(block_count(COUNT));
		motors_from_rows(rows.data(), COUNT, again.data(), set);
		double worst = 0.0, worst_again = 0.0;
		for (size_t i = 0; i < COUNT; ++i) {
			const PoseD pose = *in_double(motors.each[i]).to_pose();
			const glm::dmat3 basis = glm::mat3_cast(pose.rotation);
			const float *row = &rows[i * ROW_FLOATS];
			for (int axis = 0; axis < 3; ++axis) {
				for (int column = 0; column < 3; ++column) {
					worst = std::max(worst, std::abs(row[4 * axis + column] / pose.scale - basis[column][axis]));
				}
				worst = std::max(worst, std::abs(row[4 * axis + 3] - pose.translation[axis]) / std::max(10.0, glm::length(pose.translation)));
			}
			const PoseD back = *in_double(again[i / 8].get(int(i % 8))).to_pose();
			worst_again = std::max(worst_again, angle_between(back.rotation, pose.rotation));
			worst_again = std::max(worst_again, std::abs(back.scale / pose.scale - 1.0));
			worst_again = std::max(worst_again, glm::length(back.translation - pose.translation) / std::max(10.0, glm::length(pose.translation)));
			CHECK(again[i / 8].get(int(i % 8)).norm_squared() == doctest::Approx(1.0).epsilon(1e-6));
		}
		CHECK(worst < TOLERANCE);
		CHECK(worst_again < 2.0 * TOLERANCE);
	}
}

TEST_CASE("rows of rotations by pi about every axis, of scales 0.001 and 1,000, and of the identity") {
	std::vector<float> rows;
	std::vector<PoseD> poses;
	for (const Vector3D &axis : { Vector3D(1, 0, 0), Vector3D(0, 1, 0), Vector3D(0, 0, 1), Vector3D(1, 1, 0), Vector3D(-1, 2, 3) }) {
		for (const double angle : { 0.0, 1e-4, 2.0, PI, 4.0 }) {
			for (const double scale : { 0.001, 1.0, 1000.0 }) {
				poses.push_back({ Vector3D(1, 2, 3), axis_angle(axis, angle), scale });
				rows.resize(poses.size() * ROW_FLOATS);
				pose_to_row(pose_cast<float>(poses.back()), &rows[rows.size() - ROW_FLOATS]);
			}
		}
	}
	for (const InstructionSet set : SETS) {
		std::vector<MotorBlock> motors(block_count(poses.size()));
		motors_from_rows(rows.data(), poses.size(), motors.data(), set);
		for (size_t i = 0; i < poses.size(); ++i) {
			const PoseD pose = *in_double(motors[i / 8].get(int(i % 8))).to_pose();
			CAPTURE(i);
			CHECK(angle_between(pose.rotation, poses[i].rotation) < TOLERANCE);
			CHECK(std::abs(pose.scale / poses[i].scale - 1.0) < TOLERANCE);
			CHECK(glm::length(pose.translation - poses[i].translation) < 4.0 * TOLERANCE);
		}
	}
}

TEST_CASE("motors of weight zero give zeros, not NaN") {
	MotorBlock block;
	Motor<float> zero;
	zero.a.w = zero.b.w = 0.0f;
	zero.v.x = 3.0f;
	block.set(2, zero);
	for (const InstructionSet set : SETS) {
		float rows[8 * ROW_FLOATS];
		extract_blocks(&block, 8, rows, set);
		float points[24];
		std::fill_n(points, 24, 1.5f);
		transform_points(&block, points, 8, points, set);
		for (size_t entry = 0; entry < ROW_FLOATS; ++entry) {
			CHECK(rows[2 * ROW_FLOATS + entry] == 0.0f);
			CHECK(rows[3 * ROW_FLOATS + entry] == (entry % 5 == 0 ? 1.0f : 0.0f));
		}
		for (size_t axis = 0; axis < 3; ++axis) {
			CHECK(points[6 + axis] == 0.0f);
			CHECK(points[9 + axis] == 1.5f);
		}
	}
}

TEST_CASE("scalar and baseline instructions give the same bits, for motors too") {
	const Motors first = random_motors(76);
	const Motors second = random_motors(77);
	const std::vector<float> points = random_points(78);
	std::vector<float> results[2];
	for (const InstructionSet set : { InstructionSet::SCALAR, InstructionSet::BASELINE }) {
		std::vector<float> &result = results[int(set)];
		std::vector<MotorBlock> products(first.blocks.size());
		compose_blocks(first.blocks.data(), second.blocks.data(), products.size(), products.data(), set);
		result.resize(COUNT * ROW_FLOATS + 2 * points.size());
		extract_blocks(products.data(), COUNT, result.data(), set);
		motors_from_rows(result.data(), COUNT, products.data(), set);
		transform_points(products.data(), points.data(), COUNT, &result[COUNT * ROW_FLOATS], set);
		transform_points(first.each[3], points.data(), COUNT, &result[COUNT * ROW_FLOATS + points.size()], set);
	}
	CHECK(std::memcmp(results[0].data(), results[1].data(), results[0].size() * sizeof(float)) == 0);
}

TEST_CASE("blocks preserve motors bit for bit, and start as identities") {
	const Motors motors = random_motors(79);
	CHECK(motors.blocks[3].get(5).a == motors.each[29].a);
	CHECK(motors.blocks[3].get(5).b == motors.each[29].b);
	CHECK(motors.blocks[3].get(5).v == motors.each[29].v);
	CHECK(MotorBlock().get(6).b == Quaternion<float>(1, 0, 0, 0));
	CHECK(MotorBlock().get(6).v == Quaternion<float>(0, 0, 0, 0));
	compose_blocks(nullptr, nullptr, 0, nullptr);
	extract_blocks(nullptr, 0, nullptr);
	motors_from_rows(nullptr, 0, nullptr);
	transform_points(static_cast<const MotorBlock *>(nullptr), nullptr, 0, nullptr);
}
