#include "cga/motor/motor_factors.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

TEST_CASE("translator, rotor and dilator translate, rotate and scale") {
	Random random(12);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Vector3D x = random.vector(10.0);
		const Vector3D t = random.vector(10.0);
		const QuaternionD q = random.rotation();
		const double s = random.scale();
		CHECK(glm::length(*position_of(*translator(t).sandwich(point(x))) - (x + t)) < 1e-9);
		CHECK(glm::length(*position_of(*rotor(q).sandwich(point(x))) - q * x) < 1e-11);
		// A dilated point has the weight 1 / s.
		const Multivector dilated = point(x * s) * (1.0 / s);
		CHECK(dilator(s).sandwich(point(x))->is_equal_approx(dilated, 1e-13 * dilated.max_abs()));
		CHECK(translator(t).norm_squared() == doctest::Approx(1.0));
		CHECK(rotor(q).norm_squared() == doctest::Approx(1.0));
		CHECK(dilator(s).norm_squared() == doctest::Approx(1.0));
	}
}

TEST_CASE("a rotation by pi / 2 about z maps x to y") {
	const double half = std::sqrt(0.5);
	const Multivector turn = rotor({ half, 0.0, 0.0, half });
	CHECK(turn[0] == half);
	CHECK(turn[6] == -half); // e12
	CHECK(turn.sandwich(*Multivector::basis("e1"))->is_equal_approx(*Multivector::basis("e2"), 1e-15));
}

TEST_CASE("the paper's dilator 1 + ((1 - d) / (1 + d)) E is the same up to a factor") {
	for (const double d : { 0.01, 0.5, 1.0, 3.0, 100.0 }) {
		const Multivector paper = Multivector::scalar(1.0) + *Multivector::basis("E") * ((1.0 - d) / (1.0 + d));
		CHECK((dilator(d) * (1.0 / dilator(d)[0])).is_equal_approx(paper, 1e-15));
	}
}
