#include "cga/motor/motor.hpp"

#include "../random_poses.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

namespace {

Multivector trd(const PoseD &pose) {
	return translator(pose.translation).geometric_product(rotor(pose.rotation)).geometric_product(dilator(pose.scale));
}

double relative_difference(const Multivector &left, const Multivector &right) {
	return (left - right).max_abs() / std::max(left.max_abs(), right.max_abs());
}

Motor<double> scaled(const Motor<double> &motor, double factor) {
	return { motor.a * factor, motor.b * factor, motor.v * factor };
}

} // namespace

TEST_CASE("the minimal form is the geometric product T R D") {
	Random random(21);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const PoseD pose = random.pose();
		const auto motor = Motor<double>::from_pose(pose);
		CHECK(relative_difference(to_multivector(motor), trd(pose)) < 1e-14);
		CHECK(motor.norm_squared() == doctest::Approx(1.0).epsilon(1e-12));
		const auto parts = compose(compose(Motor<double>::translator(pose.translation), Motor<double>::rotor(pose.rotation)), Motor<double>::dilator(pose.scale));
		CHECK(relative_difference(to_multivector(parts), trd(pose)) < 1e-14);
	}
}

TEST_CASE("composition is the geometric product") {
	Random random(22);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const auto first = Motor<double>::from_pose(random.pose());
		const auto second = Motor<double>::from_pose(random.pose());
		const Multivector product = to_multivector(first).geometric_product(to_multivector(second));
		CHECK(relative_difference(to_multivector(compose(first, second)), product) < 1e-13);
	}
}

TEST_CASE("reverse and inverse agree with Multivector's") {
	Random random(23);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const auto motor = scaled(Motor<double>::from_pose(random.pose()), random.normal());
		CHECK(to_multivector(motor.reverse()) == to_multivector(motor).reverse());
		CHECK(relative_difference(to_multivector(*motor.inverse()), *to_multivector(motor).inverse_of_versor()) < 1e-9);
		const PoseD identity = *compose(motor, *motor.inverse()).to_pose();
		CHECK(angle_between(identity.rotation, PoseD().rotation) < 1e-13);
		CHECK(identity.scale == doctest::Approx(1.0).epsilon(1e-13));
		CHECK(glm::length(identity.translation) < 1e-12);
	}
}

TEST_CASE("extraction returns the pose for any weight") {
	Random random(24);
	for (const double weight : { 1.0, -1.0, 1e-3, 1e3, -7.5, 1e-100, 1e100 }) {
		for (int repeat = 0; repeat < 500; ++repeat) {
			const PoseD pose = random.pose();
			const auto extracted = scaled(Motor<double>::from_pose(pose), weight).to_pose();
			REQUIRE(extracted.has_value());
			CHECK(difference(*extracted, pose) < 1e-14);
		}
	}
}

TEST_CASE("extraction in float, 10 km from the origin and at scales 0.01 to 100") {
	Random random(25);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const Pose<float> pose = pose_cast<float>(random.pose(1e4));
		const auto extracted = Motor<float>::from_pose(pose).to_pose();
		REQUIRE(extracted.has_value());
		CHECK(difference(pose_cast<double>(*extracted), pose_cast<double>(pose)) < 6e-7);
	}
}

TEST_CASE("degenerate poses survive the round trip") {
	const QuaternionD identity(1.0, 0.0, 0.0, 0.0);
	const PoseD poses[] = {
		{},
		{ { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, 1.0 },
		{ { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 1.0, 0.0 }, 0.01 },
		{ { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 0.0, -1.0 }, 100.0 },
		{ { 1e4, -1e4, 1e4 }, -identity, 1.0 },
		{ { 1e-30, 0.0, 0.0 }, identity, 1.0 },
	};
	for (const PoseD &pose : poses) {
		CHECK(difference(*Motor<double>::from_pose(pose).to_pose(), pose) < 1e-15);
	}
	CHECK(Motor<double>::from_pose(PoseD()).to_pose()->rotation.w == 1.0);
	CHECK_FALSE(Motor<double>{ { 0.0, 0.0, 0.0, 0.0 }, identity, identity }.to_pose().has_value());
	CHECK_FALSE(Motor<double>{ identity, { 0.0, 0.0, 0.0, 0.0 }, identity }.inverse().has_value());
}

TEST_CASE("a motor maps points as its multivector and its pose do") {
	Random random(26);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const PoseD pose{ random.vector(3.0), random.rotation(), random.uniform(0.5, 2.0) };
		const auto motor = scaled(Motor<double>::from_pose(pose), random.uniform(0.1, 3.0));
		const Vector3D x = random.vector(3.0);
		CHECK(glm::length(motor.transform_point(x) - transformed(pose, x)) < 1e-12);
		CHECK(glm::length(*position_of(*to_multivector(motor).sandwich(point(x))) - transformed(pose, x)) < 1e-9);
	}
}

TEST_CASE("normalizing removes weight and noise, as (n + h - k) X / (n sqrt(2 (n + h))) from the left does") {
	Random random(27);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const auto exact = Motor<double>::from_pose({ random.vector(3.0), random.rotation(), random.uniform(0.5, 2.0) });
		Motor<double> noisy = scaled(exact, random.uniform(0.2, 5.0));
		const double noise = 1e-3;
		for (Quaternion<double> *part : { &noisy.a, &noisy.b, &noisy.v }) {
			*part += Quaternion<double>(random.normal(), random.normal(), random.normal(), random.normal()) * noise;
		}
		const auto repaired = noisy.normalized();
		REQUIRE(repaired.has_value());

		const Multivector x = to_multivector(noisy);
		const Multivector square = x.geometric_product(x.reverse());
		const double h = square[0];
		const Multivector k = square.grade(4);
		const double n = std::sqrt(h * h - k.geometric_product(k)[0]);
		const Multivector expected = (Multivector::scalar(n + h) - k).geometric_product(x) * (1.0 / (n * std::sqrt(2.0 * (n + h))));
		CHECK(relative_difference(to_multivector(*repaired), expected) < 1e-13);

		// A motor again: M M~ = 1, and close to what it was.
		const Multivector unit = to_multivector(*repaired);
		CHECK(unit.geometric_product(unit.reverse()).is_equal_approx(Multivector::scalar(1.0), 1e-12));
		CHECK(difference(*repaired->to_pose(), *exact.to_pose()) < 0.1);
	}
	const QuaternionD identity(1.0, 0.0, 0.0, 0.0);
	CHECK_FALSE(Motor<double>{ identity, -identity, identity }.normalized().has_value());
	CHECK_FALSE(Motor<double>{ identity, { 0.0, 0.0, 0.0, 0.0 }, identity }.normalized().has_value());
}

TEST_CASE("multivectors that are motors become motors, others are rejected") {
	Random random(28);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const PoseD pose = random.pose();
		const auto motor = to_motor(trd(pose) * -2.5);
		REQUIRE(motor.has_value());
		CHECK(difference(*motor->to_pose(), pose) < 1e-12);
		// Detects other coefficients, and violations of A || B and v . b = 0.
		CHECK_FALSE(to_motor(trd(pose) + *Multivector::basis("e1") * (1e-3 * trd(pose).max_abs())).has_value());
	}
	for (const char *name : { "eo", "einf", "E", "I", "e1", "e14", "e1234", "e1245" }) {
		CAPTURE(name);
		CHECK_FALSE(to_motor(*Multivector::basis(name)).has_value());
	}
	CHECK(to_motor(*Multivector::basis("e12")).has_value()); // a rotation by pi
	CHECK_FALSE(to_motor(Multivector()).has_value());
	CHECK_FALSE(to_motor(Multivector::scalar(1.0) + *Multivector::basis("e1234")).has_value());
	CHECK_FALSE(to_motor(random.multivector()).has_value());
}
