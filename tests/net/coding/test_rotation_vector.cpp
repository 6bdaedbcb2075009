#include "net/coding/rotation_vector.hpp"

#include "../../cga/random_poses.hpp"

#include <doctest/doctest.h>

using namespace net;
using cga_test::PI;
using cga_test::QuaternionD;
using cga_test::Vector3D;

namespace {

double max_difference(const QuaternionD &a, const QuaternionD &b) {
	return std::max({ std::abs(a.w - b.w), std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z) });
}

/// exp_rotation() with the C library's sine and cosine.
QuaternionD by_library(const Vector3D &vector) {
	const double angle = glm::length(vector);
	const double scale = angle == 0.0 ? 0.5 : std::sin(angle / 2.0) / angle;
	return { std::cos(angle / 2.0), vector.x * scale, vector.y * scale, vector.z * scale };
}

} // namespace

TEST_CASE("rotation vector: exp agrees with the standard library to the last bits up to an angle of pi, to 1e-10 at the end of its range") {
	cga_test::Random random(21);
	double worst[9] = {};
	for (int i = 0; i < 20000; ++i) {
		const double angle = 8.0 * i / 20000.0;
		const Vector3D vector = glm::normalize(random.vector(1.0)) * angle;
		double &max = worst[int(angle)];
		max = std::max(max, max_difference(exp_rotation(vector), by_library(vector)));
	}
	const double bounds[8] = { 2e-15, 2e-15, 2e-15, 8e-15, 2e-13, 2e-12, 1e-11, 1e-10 };
	for (int radians = 0; radians < 8; ++radians) {
		CAPTURE(radians);
		CHECK(worst[radians] < bounds[radians]);
	}
}

TEST_CASE("rotation vector: exp at the ends of its range") {
	CHECK(exp_rotation(Vector3D(0.0)) == QuaternionD(1.0, 0.0, 0.0, 0.0));
	const QuaternionD tiny = exp_rotation(Vector3D(1e-12, -2e-12, 0.0));
	CHECK(tiny.w == 1.0);
	CHECK(tiny.x == doctest::Approx(5e-13).epsilon(1e-12));
	CHECK(tiny.y == doctest::Approx(-1e-12).epsilon(1e-12));
	CHECK(max_difference(exp_rotation(Vector3D(0.0, PI, 0.0)), { 0.0, 0.0, 1.0, 0.0 }) < 4e-15);
	CHECK(max_difference(exp_rotation(Vector3D(0.0, 0.0, 2.0 * PI)), { -1.0, 0.0, 0.0, 0.0 }) < 1e-11);
}

TEST_CASE("rotation vector: exp has unit length, which segments rely on") {
	cga_test::Random random(22);
	double worst = 0.0;
	for (int i = 0; i < 10000; ++i) {
		const Vector3D vector = glm::normalize(random.vector(1.0)) * random.uniform(0.0, 8.0);
		worst = std::max(worst, std::abs(glm::length(exp_rotation(vector)) - 1.0));
	}
	CHECK(worst < 1e-10);
}

TEST_CASE("rotation vector: log gives the shortest vector, for angles from 0 to pi") {
	cga_test::Random random(23);
	for (const double angle : { 0.0, 1e-300, 1e-12, 1e-9, 3e-9, 1e-5, 0.1, 1.0, 3.0, PI - 1e-7, PI - 1e-12 }) {
		for (int i = 0; i < 50; ++i) {
			const Vector3D vector = glm::normalize(random.vector(1.0)) * angle;
			const QuaternionD q = by_library(vector);
			CAPTURE(angle);
			CHECK(glm::length(log_rotation(q) - vector) <= 1e-15 + 1e-15 * angle);
			CHECK(glm::length(log_rotation(-q) - vector) <= 1e-15 + 1e-15 * angle); // q and -q are one rotation
		}
	}
	CHECK(glm::length(log_rotation({ 0.0, 0.0, 1.0, 0.0 })) == doctest::Approx(PI).epsilon(1e-15));
}

TEST_CASE("rotation vector: beyond an angle of pi, log gives the shorter rotation in the opposite direction") {
	cga_test::Random random(24);
	for (const double angle : { PI + 1e-6, 4.0, 6.0, 2.0 * PI - 1e-6 }) {
		const Vector3D axis = glm::normalize(random.vector(1.0));
		CAPTURE(angle);
		CHECK(glm::length(log_rotation(exp_rotation(axis * angle)) - axis * (angle - 2.0 * PI)) < (angle < 5.0 ? 2e-13 : 1e-11));
	}
}
