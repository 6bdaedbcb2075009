#include "cga/versor/logarithm.hpp"

#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/versor/exponential.hpp"
#include "long_multivector.hpp"
#include "random_versors.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace cga;
using namespace cga_test;

namespace {

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

Multivector log_of(const Multivector &versor) {
	const MultivectorResult result = log(versor);
	REQUIRE_MESSAGE(result, describe(result.error()));
	return *result;
}

// How far exp(log(M)) is from M or -M.
double round_trip_error(const Multivector &versor) {
	return relative_error_up_to_sign(*exp(log_of(versor)), versor);
}

} // namespace

TEST_CASE("log inverts exp over the grid of angle and ln of the scale, digit for digit in each part") {
	Random random(111);
	double worst = 0.0;
	double worst_dilation = 0.0;
	for (const double angle : { 0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 2.0, 3.0, PI - 1e-6, PI - 1e-12 }) {
		for (const double dilation : { 0.0, 1e-12, -1e-12, 1e-6, -1e-6, 0.01, -0.01, 1.0, -1.0, 5.0, -5.0 }) {
			for (const double velocity : { 0.0, 1e-6, 1.0, 1000.0 }) {
				const Multivector bivector = to_multivector(MotorLog<double>{ glm::normalize(random.vector(1.0)) * angle, random.vector(velocity), dilation });
				const Multivector again = log_of(*exp(bivector));
				if (bivector == Multivector()) {
					CHECK(again == Multivector());
					continue;
				}
				worst = std::max(worst, relative_error(again, bivector));
				const double difference = std::abs(again[blade_index("e45")] - 0.5 * -dilation);
				worst_dilation = std::max(worst_dilation, dilation == 0.0 ? difference : difference / std::abs(dilation));
			}
		}
	}
	CHECK(worst < 1e-13);
	CHECK(worst_dilation < 1e-13);
}

TEST_CASE("rotation by pi: the versor determines the direction, and exp returns the versor") {
	Random random(112);
	for (const double dilation : { 0.0, 1e-12, -5.0, 2.0 }) {
		for (int repeat = 0; repeat < 200; ++repeat) {
			const Multivector turn = rotor({ 0.0, 1.0, 0.0, 0.0 });
			const Multivector motor = translator(random.vector(3.0)).geometric_product(turn).geometric_product(dilator(std::exp(dilation)));
			CHECK(relative_error(*exp(log_of(motor)), motor) < 1e-13);
			CHECK(relative_error(*exp(log_of(-motor)), -motor) < 1e-13);
		}
	}
	CHECK(log_of(rotor({ 0.0, 0.0, 0.0, 1.0 }))[blade_index("e12")] == doctest::Approx(-PI / 2.0).epsilon(1e-15));
}

TEST_CASE("M and -M have the same logarithm, whose exp is the one of positive scalar part") {
	Random random(113);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const Multivector versor = repeat % 2 == 0 ? random_even_versor(random) : to_multivector(Motor<double>::from_pose(random.pose()));
		if (std::abs(versor[0]) < 1e-6) {
			continue;
		}
		const Multivector logarithm = log_of(versor);
		CHECK(log_of(-versor) == logarithm);
		const Multivector expected = versor[0] < 0.0 ? -versor : versor;
		CHECK(relative_error(*exp(logarithm), expected) < 1e-10);
	}
}

TEST_CASE("the weight is the scalar part of the logarithm") {
	Random random(114);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const Multivector versor = repeat % 2 == 0 ? random_even_versor(random) : to_multivector(Motor<double>::from_pose(random.pose(1.0)));
		const double weight = std::pow(10.0, random.uniform(-5.0, 5.0));
		const Multivector logarithm = log_of(versor * weight);
		CHECK(logarithm[0] == doctest::Approx(std::log(weight)).epsilon(1e-9));
		CHECK(relative_error(logarithm.grade(2), log_of(versor)) < 1e-9);
		CHECK(relative_error_up_to_sign(*exp(logarithm), versor * weight) < 1e-10);
	}
	CHECK(log_of(Multivector::scalar(2.0)) == Multivector::scalar(std::log(2.0)));
	CHECK(log_of(Multivector::scalar(1.0)) == Multivector());
	CHECK(log_of(Multivector::scalar(1e308))[0] == doctest::Approx(308.0 * std::log(10.0)));
	CHECK(log_of(Multivector::scalar(5e-324))[0] == doctest::Approx(-1074.0 * std::log(2.0)));
}

TEST_CASE("products of two and of four reflections and inversions") {
	Random random(115);
	double worst = 0.0;
	for (int repeat = 0; repeat < 6000; ++repeat) {
		worst = std::max(worst, round_trip_error(random_even_versor(random)));
	}
	CHECK(worst < 1e-11);
}

TEST_CASE("products of motors with large translations") {
	Random random(121);
	double worst = 0.0;
	for (const double distance : { 1e-6, 1.0, 1e3, 1e6, 1e9 }) {
		for (int repeat = 0; repeat < 500; ++repeat) {
			const Multivector motor = to_multivector(Motor<double>::from_pose(random.pose(distance)));
			const Multivector product = translator(random.vector(distance)).geometric_product(motor).geometric_product(rotor(random.rotation()));
			worst = std::max(worst, round_trip_error(product * random.uniform(-3.0, 3.0)));
		}
	}
	CHECK(worst < 1e-13);
}

TEST_CASE("log inverts exp for random bivectors of small rotations") {
	Random random(116);
	double worst = 0.0;
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector bivector = random.multivector().grade(2) * random.uniform(0.0, 0.3);
		worst = std::max(worst, relative_error(log_of(*exp(bivector)), bivector));
	}
	CHECK(worst < 1e-13);
	for (const double size : { 1e-15, 1e-12, 1e-9, 1e-6, 1e-3 }) {
		for (int repeat = 0; repeat < 100; ++repeat) {
			const Multivector bivector = random.multivector().grade(2) * size;
			CHECK(relative_error(log_of(*exp(bivector)), bivector) < 1e-13);
		}
	}
}

TEST_CASE("the logarithm rotates by at most pi in each of its two planes") {
	Random random(117);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector bivector = log_of(random_even_versor(random)).grade(2);
		const Multivector square = bivector.geometric_product(bivector);
		const double s = square[0];
		const double w_squared = square.grade(4).scalar_product(square.grade(4));
		// The smaller of the squares of the two parts: -(angle / 2)^2 of a rotation.
		const double least = 0.5 * (s - std::sqrt(std::max(0.0, s * s - w_squared)));
		CHECK(least > -(PI / 2.0) * (PI / 2.0) - 1e-9 * (1.0 + bivector.max_abs() * bivector.max_abs()));
	}
}

TEST_CASE("transversions") {
	Random random(118);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Vector3D t = random.vector(std::pow(10.0, random.uniform(-6.0, 2.0)));
		const Multivector logarithm = log_of(transversion(t));
		CHECK(relative_error(logarithm, euclidean(t).geometric_product(e_origin())) < 1e-12);
		const Multivector mixed = transversion(t).geometric_product(rotor(random.rotation())).geometric_product(translator(random.vector(1.0)));
		CHECK(round_trip_error(mixed) < 1e-11);
	}
}

TEST_CASE("two rotations at once, including rotations by pi") {
	Random random(119);
	constexpr double HALF_TURN = PI / 2.0;
	for (const double first : { 0.0, 1e-12, 1e-6, 0.3, 1.0, HALF_TURN - 1e-6, HALF_TURN - 1e-12, HALF_TURN }) {
		for (const double second : { 0.0, 1e-12, 1e-6, 0.3, 1.0, HALF_TURN - 1e-6, HALF_TURN - 1e-12, HALF_TURN }) {
			for (const double sign : { 1.0, -1.0 }) {
				const Multivector plain = *exp(blade("e12") * first + blade("e34") * (sign * second));
				CAPTURE(first);
				CAPTURE(second);
				CHECK(round_trip_error(plain) < 1e-11);
				const Multivector turn = random_even_versor(random);
				const double size = turn.max_abs() * turn.max_abs();
				CHECK(round_trip_error(turn.geometric_product(plain).geometric_product(turn.reverse())) < 1e-11 * (1.0 + size));
			}
		}
	}
	// The double rotation by pi alone: any pair of planes is valid; exp verifies it.
	CHECK(relative_error(*exp(log_of(blade("e1234"))), blade("e1234")) < 1e-15);
	CHECK(relative_error(*exp(log_of(-blade("e1234"))), -blade("e1234")) < 1e-15);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const Multivector turn = random_even_versor(random);
		const Multivector tilted = turn.geometric_product(blade("e1234")).geometric_product(turn.reverse()).grade(4);
		CHECK(relative_error(*exp(log_of(tilted)), tilted) < 1e-12 * (1.0 + std::pow(tilted.max_abs(), 2.0)));
	}
}

TEST_CASE("log() reports why an element has no logarithm") {
	CHECK(log(blade("e1")).error() == AlgebraError::ODD_HAS_NO_LOGARITHM);
	CHECK(log(blade("I")).error() == AlgebraError::ODD_HAS_NO_LOGARITHM);
	// One real and one imaginary inversion: M M~ = -1.
	CHECK(log(blade("e15")).error() == AlgebraError::NEGATIVE_HAS_NO_LOGARITHM);
	CHECK(log(blade("1") + blade("e1")).error() == AlgebraError::NOT_A_VERSOR);
	CHECK(log(blade("e12") + blade("e34")).error() == AlgebraError::NOT_A_VERSOR);
	CHECK(log(e_infinity()).error() == AlgebraError::NOT_A_VERSOR);
	CHECK(log(Multivector()).error() == AlgebraError::ZERO_HAS_NO_LOGARITHM);
	CHECK(log(blade("e12") * std::numeric_limits<double>::infinity()).error() == AlgebraError::NOT_FINITE);
	Random random(120);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		CHECK_FALSE(log(random_product(random, 1 + repeat % 2 * 2)));
		CHECK_FALSE(log(random.multivector()));
	}
}
