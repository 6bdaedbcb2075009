#include "net/coding/quantization.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace net;

namespace {

glm::quat random_rotation(std::mt19937 &random) {
	std::normal_distribution<float> normal;
	return glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random)));
}

/// Angle between two rotations in degrees, computed from the chord, which is accurate for small angles.
double angle_between(const glm::quat &a, const glm::quat &b) {
	const double sign = glm::dot(a, b) < 0 ? -1.0 : 1.0;
	double chord = 0;
	for (int i = 0; i < 4; ++i) {
		const double d = double(a[i]) - sign * double(b[i]);
		chord += d * d;
	}
	return 4.0 * std::asin(std::fmin(std::sqrt(chord) / 2.0, 1.0)) * 180.0 / 3.14159265358979323846;
}

} // namespace

TEST_CASE("rotors: the error stays within the tolerance, and fewer bits would not suffice") {
	std::mt19937 random(7);
	for (const float tolerance : { 5.0f, 1.0f, 0.25f, 0.05f, 0.01f }) {
		const int bits = rotor_bits(tolerance);
		double worst = 0;
		for (int i = 0; i < 20000; ++i) {
			const glm::quat q = random_rotation(random);
			const std::optional<glm::quat> back = dequantize_rotor(quantize_rotor(q, bits), bits);
			REQUIRE(back);
			worst = std::fmax(worst, angle_between(q, *back));
		}
		CAPTURE(tolerance);
		CHECK(worst <= tolerance);
		CHECK(worst > tolerance / 8); // not finer than needed
	}
}

TEST_CASE("rotors: the identity and rotations by pi about the axes are exact") {
	for (const glm::quat &q : { glm::quat(1, 0, 0, 0), glm::quat(0, 1, 0, 0), glm::quat(0, 0, 1, 0), glm::quat(0, 0, 0, 1) }) {
		const std::optional<glm::quat> back = dequantize_rotor(quantize_rotor(q, 9), 9);
		REQUIRE(back);
		CHECK(*back == q);
	}
}

TEST_CASE("rotors: q and -q have the same code") {
	std::mt19937 random(11);
	for (int i = 0; i < 1000; ++i) {
		const glm::quat q = random_rotation(random);
		const SmallestThree a = quantize_rotor(q, 10);
		const SmallestThree b = quantize_rotor(-q, 10);
		CHECK(a.dropped == b.dropped);
		CHECK(a.level[0] == b.level[0]);
		CHECK(a.level[1] == b.level[1]);
		CHECK(a.level[2] == b.level[2]);
	}
}

TEST_CASE("rotors: components that no unit quaternion has are rejected") {
	CHECK_FALSE(dequantize_rotor(SmallestThree{ 3, { 0, 0, 0 } }, 10)); // three of -1/sqrt(2)
	CHECK_FALSE(dequantize_rotor(SmallestThree{ 3, { 1023, 511, 511 } }, 10)); // a level above 2n
}

TEST_CASE("positions: half the cell's diagonal is the tolerance") {
	CHECK(double(position_step(0.002f)) * std::sqrt(3.0) / 2.0 == doctest::Approx(0.002).epsilon(1e-6));
}

TEST_CASE("scales: relative error at most 8.5e-5, 1 is exact, scales out of range are rejected") {
	for (double scale = 1.0 / 60000; scale < 60000; scale *= 1.0137) {
		const std::optional<int32_t> level = quantize_scale(float(scale));
		REQUIRE(level);
		CHECK(std::abs(double(dequantize_scale(*level)) / scale - 1) < 8.5e-5);
	}
	CHECK(quantize_scale(1.0f) == 0);
	CHECK(dequantize_scale(0) == 1.0f);
	for (const float bad : { 0.0f, -1.0f, 1e-6f, 1e6f, INFINITY, NAN }) {
		CHECK_FALSE(quantize_scale(bad));
	}
}
