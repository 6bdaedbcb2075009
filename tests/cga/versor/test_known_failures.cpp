#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
#include "cga/versor/power.hpp"
#include "long_multivector.hpp"
#include "random_versors.hpp"

#include <doctest/doctest.h>

// Known errors of other libraries (named in the cases) in exponentials and logarithms, with general multivectors;
// tests/cga/motor/test_motor_exp.cpp has the same cases with poses.

using namespace cga;
using namespace cga_test;

namespace {

Multivector log_of(const Multivector &versor) {
	const MultivectorResult result = log(versor);
	REQUIRE_MESSAGE(result, describe(result.error()));
	return *result;
}

Multivector turn_about_z(double angle) {
	return rotor({ std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle) });
}

} // namespace

TEST_CASE("log of a pure translation is -(1/2) t e_inf (NaN in klein)") {
	Random random(151);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Vector3D t = random.vector(std::pow(10.0, random.uniform(-12.0, 12.0)));
		const Multivector expected = euclidean(t).geometric_product(e_infinity()) * -0.5;
		CHECK(relative_error(log_of(translator(t)), expected) < 1e-15);
		CHECK(relative_error(*cga::sqrt(translator(t)), translator(t * 0.5)) < 1e-15);
	}
	CHECK(log_of(translator(Vector3D(0.0))) == Multivector());
}

TEST_CASE("log of angles below 1e-4 keeps every digit (NaN in klein's rotor log)") {
	for (double angle = 1e-3; angle > 1e-300; angle *= 0.1) {
		CAPTURE(angle);
		CHECK(log_of(turn_about_z(angle))[E12] == doctest::Approx(-0.5 * angle).epsilon(1e-15));
		const Multivector motor = translator({ 1.0, 2.0, 3.0 }).geometric_product(turn_about_z(angle));
		CHECK(log_of(motor)[E12] == doctest::Approx(-0.5 * angle).epsilon(1e-15));
	}
}

TEST_CASE("log of a rotation by pi, alone and with translation and scale (wrong in clifford's general_logarithm)") {
	Random random(152);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Vector3D axis = glm::normalize(random.vector(1.0));
		const double angle = repeat % 4 == 0 ? PI : PI - std::pow(10.0, random.uniform(-16.0, -1.0));
		const Multivector turn = rotor({ angle == PI ? 0.0 : std::cos(0.5 * angle), axis.x * std::sin(0.5 * angle), axis.y * std::sin(0.5 * angle), axis.z * std::sin(0.5 * angle) });
		const Multivector motor = translator(random.vector(5.0)).geometric_product(turn).geometric_product(dilator(repeat % 2 == 0 ? 1.0 : random.uniform(0.2, 5.0)));
		const Multivector logarithm = log_of(motor);
		CHECK(relative_error(*exp(logarithm), motor) < 1e-13);
		const MotorLog<double> parts = *to_motor_log(logarithm);
		CHECK(glm::length(parts.rotation) == doctest::Approx(angle).epsilon(1e-15));
		CHECK(glm::length(parts.rotation - axis * angle) < 1e-14);
	}
}

TEST_CASE("q and -q, the identity and minus it: one logarithm (NaN in GA-Unity)") {
	Random random(153);
	CHECK(log_of(rotor({ 1.0, 0.0, 0.0, 0.0 })) == Multivector());
	CHECK(log_of(rotor({ -1.0, 0.0, 0.0, 0.0 })) == Multivector());
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const QuaternionD q = random.rotation();
		CHECK(log_of(rotor(q)) == log_of(rotor(-q)));
		// q and -q are the same rotation: there is no motion between them.
		const Multivector nothing = rotor(-q).geometric_product(rotor(q).reverse());
		CHECK(log_of(nothing).max_abs() < 1e-15);
	}
}

TEST_CASE("exp and log are the closed form of the whole motor, not of its translator and rotor separately (gafro's)") {
	// A screw motion along z and about the axis through (1, 0, 0): all of its powers stay on the screw.
	const Multivector turn = translator({ 1.0, 0.0, 0.0 }).geometric_product(turn_about_z(2.0)).geometric_product(translator({ -1.0, 0.0, 0.0 }));
	const Multivector screw = translator({ 0.0, 0.0, 3.0 }).geometric_product(turn);
	for (const double part : { 0.25, 0.5, 0.75 }) {
		const Multivector expected = translator({ 0.0, 0.0, 3.0 * part }).geometric_product(translator({ 1.0, 0.0, 0.0 })).geometric_product(turn_about_z(2.0 * part)).geometric_product(translator({ -1.0, 0.0, 0.0 }));
		CHECK(relative_error(*power(screw, part), expected) < 1e-15);
	}
	// The split form's logarithm is log T + log R, whose exponential is another motor.
	const Motor<double> motor = *to_motor(screw);
	const Multivector split = log_of(translator(motor.to_pose()->translation)) + log_of(rotor(motor.to_pose()->rotation));
	CHECK(relative_error(*exp(split), screw) > 0.1);
	CHECK(relative_error(*exp(log_of(screw)), screw) < 1e-15);
}

TEST_CASE("a sum of motors is not a motor; normalizing it from the left gives one, from the right does not") {
	Random random(154);
	double worst_from_the_right = 0.0;
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const PoseD from = random.rigid_pose(1.0), to = random.rigid_pose(1.0);
		const Multivector blend = to_multivector(Motor<double>::from_pose(from)) * 0.4 + to_multivector(Motor<double>::from_pose(to)) * 0.6;
		CHECK_FALSE(is_motor(blend));
		const Multivector unit = *normalized(blend);
		CHECK(is_motor(unit));
		// With noise in all twelve coefficients, the two sides give different results.
		const Motor<double> exact = Motor<double>::from_pose({ random.vector(1.0), random.rotation(), 2.0 });
		const auto shake = [&](const QuaternionD &q) { return q + QuaternionD(random.normal(), random.normal(), random.normal(), random.normal()) * 1e-2; };
		const Multivector x = to_multivector(Motor<double>{ shake(exact.a), shake(exact.b), shake(exact.v) });
		const Multivector square = x.geometric_product(x.reverse());
		const double n = std::sqrt(square[0] * square[0] - square.grade(4).geometric_product(square.grade(4))[0]);
		const Multivector factor = (Multivector::scalar(n + square[0]) - square.grade(4)) * (1.0 / (n * std::sqrt(2.0 * (n + square[0]))));
		const auto error = [](const Multivector &m) { return (m.geometric_product(m.reverse()) - Multivector::scalar(1.0)).max_abs(); };
		CHECK(error(factor.geometric_product(x)) < 1e-13);
		CHECK(error(*normalized(x)) < 1e-13);
		worst_from_the_right = std::max(worst_from_the_right, error(x.geometric_product(factor)));
	}
	CHECK(worst_from_the_right > 1e-3);
}
