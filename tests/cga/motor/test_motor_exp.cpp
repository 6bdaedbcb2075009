#include "cga/motor/motor_exp.hpp"

#include "../random_poses.hpp"
#include "cga/motor/motor_multivector.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

namespace {

// The exponential by its definition, with the argument halved until the series is short.
Multivector exp_by_series(const Multivector &bivector) {
	constexpr int HALVINGS = 10;
	const Multivector small = bivector * std::ldexp(1.0, -HALVINGS);
	Multivector sum = Multivector::scalar(1.0);
	Multivector term = sum;
	for (int k = 1; k < 20; ++k) {
		term = term.geometric_product(small) * (1.0 / k);
		sum += term;
	}
	for (int halving = 0; halving < HALVINGS; ++halving) {
		sum = sum.geometric_product(sum);
	}
	return sum;
}

MotorLog<double> random_log(Random &random, double angle) {
	return { glm::normalize(random.vector(1.0)) * angle, random.vector(5.0), random.uniform(-3.0, 3.0) };
}

double length(const Vector3D &vector) {
	return glm::length(vector);
}

} // namespace

TEST_CASE("exp is the series of the bivector -(1/2) (w1 e23 - w2 e13 + w3 e12 + v e_inf + sigma E)") {
	Random random(31);
	for (const double angle : { 0.0, 1e-9, 1e-4, 0.1, 1.0, 2.0, PI, 5.0 }) {
		for (int repeat = 0; repeat < 50; ++repeat) {
			const MotorLog<double> log = random_log(random, angle);
			const Multivector closed = to_multivector(exp(log));
			const Multivector series = exp_by_series(to_multivector(log));
			CHECK((closed - series).max_abs() < 2e-12 * series.max_abs());
		}
	}
}

TEST_CASE("log undoes exp for angles up to pi") {
	Random random(32);
	for (const double angle : { 0.0, 1e-300, 1e-12, 1e-8, 1e-4, 0.5, 1.5, 3.0, PI - 1e-6, PI - 1e-12 }) {
		for (int repeat = 0; repeat < 200; ++repeat) {
			const MotorLog<double> log = random_log(random, angle);
			const MotorLog<double> again = *cga::log(exp(log));
			CHECK(length(again.rotation - log.rotation) < 2e-15);
			CHECK(length(again.velocity - log.velocity) < 1e-13 * length(log.velocity));
			CHECK(again.dilation == doctest::Approx(log.dilation).epsilon(1e-13));
		}
	}
}

TEST_CASE("small angles and small dilations lose no digits") {
	for (const double angle : { 0.0, 1e-9, 1e-7, 1e-5 }) {
		for (const double dilation : { 0.0, 1e-12, -1e-9, 1e-7, -1e-5 }) {
			// phi(z) = 1 + z/2 + z^2/6 + z^3/24, for z this small; its real and imaginary parts.
			const double d2 = dilation * dilation;
			const double a2 = angle * angle;
			const double real = 1.0 + dilation / 2.0 + (d2 - a2) / 6.0 + (dilation * d2 - 3.0 * dilation * a2) / 24.0;
			const double imaginary = angle / 2.0 + dilation * angle / 3.0 + (3.0 * d2 * angle - angle * a2) / 24.0;
			const PoseD pose = exp_to_pose<double>({ { 0.0, 0.0, angle }, { 1.0, 0.0, 0.0 }, dilation });
			CAPTURE(angle);
			CAPTURE(dilation);
			CHECK(std::abs(pose.translation.x - real) < 1e-15);
			CHECK(std::abs(pose.translation.y - imaginary) < 1e-15);
			CHECK(pose.translation.z == 0.0);
			CHECK(std::abs(pose.scale - 1.0 - std::expm1(dilation)) < 1e-15);
		}
	}
}

TEST_CASE("exp undoes log for random poses, in double and float") {
	Random random(33);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		const PoseD pose = random.pose();
		CHECK(difference(exp_to_pose(log_of_pose(pose)), pose) < 1e-14);
		const Pose<float> single = pose_cast<float>(pose);
		CHECK(difference(pose_cast<double>(exp_to_pose(log_of_pose(single))), pose_cast<double>(single)) < 3e-6);
	}
}

TEST_CASE("known failures of other libraries") {
	const QuaternionD identity(1.0, 0.0, 0.0, 0.0);
	// A pure translation: NaN in klein.
	const MotorLog<double> translation = log_of_pose<double>({ { 1.0, -2.0, 3.0 }, identity, 1.0 });
	CHECK(translation.rotation == Vector3D(0.0));
	CHECK(translation.velocity == Vector3D(1.0, -2.0, 3.0));
	CHECK(translation.dilation == 0.0);
	// An angle below 1e-4: NaN in klein's rotor log.
	const MotorLog<double> small = log_of_pose<double>({ Vector3D(0.0), axis_angle({ 0.0, 0.0, 1.0 }, 1e-9), 1.0 });
	CHECK(small.rotation.z == doctest::Approx(1e-9).epsilon(1e-15));
	// A rotation by pi: wrong in clifford's general_logarithm.
	const MotorLog<double> half = log_of_pose<double>({ { 2.0, 0.0, 5.0 }, { 0.0, 0.0, 0.0, 1.0 }, 1.0 });
	CHECK(half.rotation.z == doctest::Approx(PI).epsilon(1e-15));
	CHECK(half.velocity.x == doctest::Approx(0.0).epsilon(1e-14));
	CHECK(half.velocity.y == doctest::Approx(-PI).epsilon(1e-14));
	CHECK(half.velocity.z == doctest::Approx(5.0).epsilon(1e-14));
	// q and -q: NaN in GA-Unity.
	const PoseD pose{ { 1.0, 2.0, 3.0 }, axis_angle({ 1.0, 1.0, 0.0 }, 0.7), 2.0 };
	const MotorLog<double> plus = log_of_pose(pose);
	const MotorLog<double> minus = log_of_pose<double>({ pose.translation, -pose.rotation, pose.scale });
	CHECK(plus.rotation == minus.rotation);
	CHECK(plus.velocity == minus.velocity);
}

TEST_CASE("a power is the exponential of the multiple of the logarithm") {
	Random random(34);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const PoseD pose = random.pose();
		const double exponent = random.uniform(-2.0, 2.0);
		const MotorLog<double> log = log_of_pose(pose);
		const PoseD expected = exp_to_pose<double>({ log.rotation * exponent, log.velocity * exponent, log.dilation * exponent });
		CHECK(difference(power_of_pose(pose, exponent), expected) < 1e-13);
	}
}

TEST_CASE("powers add") {
	Random random(35);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const auto motor = Motor<double>::from_pose(random.pose());
		const double part = random.uniform(0.0, 1.0);
		const Motor<double> whole = compose(*power(motor, part), *power(motor, 1.0 - part));
		CHECK(difference(*whole.to_pose(), *motor.to_pose()) < 1e-12);
	}
}

TEST_CASE("the square root is normalize(1 + M)") {
	Random random(36);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		Motor<double> motor = Motor<double>::from_pose({ random.vector(5.0), random.rotation(), random.uniform(0.2, 5.0) });
		if (motor.a.w < 0.0) {
			motor = { -motor.a, -motor.b, -motor.v };
		}
		const Motor<double> root = *power(motor, 0.5);
		Motor<double> sum = motor;
		sum.a.w += 1.0;
		sum.b.w += 1.0;
		CHECK(difference(*sum.normalized()->to_pose(), *root.to_pose()) < 1e-12);
		CHECK(difference(*compose(root, root).to_pose(), *motor.to_pose()) < 1e-12);
	}
}

TEST_CASE("a motor of weight zero has no logarithm and no power") {
	const Motor<double> nothing{ { 0.0, 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0 } };
	CHECK_FALSE(cga::log(nothing).has_value());
	CHECK_FALSE(power(nothing, 0.5).has_value());
}
