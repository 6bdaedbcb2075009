#include "cga/versor/exponential.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "long_multivector.hpp"
#include "random_versors.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace cga;
using namespace cga_test;

namespace {

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

double error_of_exp(const Multivector &x) {
	const MultivectorResult result = exp(x);
	REQUIRE(result);
	return relative_error(*result, long_exp(x));
}

} // namespace

TEST_CASE("exp of motors' bivectors over the grid of angle and ln of the scale") {
	Random random(101);
	double worst = 0.0;
	for (const double angle : { 0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 2.0, 3.0, PI - 1e-6, PI - 1e-12, PI, 5.0, 7.0 }) {
		for (const double dilation : { 0.0, 1e-12, -1e-12, 1e-6, -1e-6, 0.01, -0.01, 1.0, -1.0, 5.0, -5.0 }) {
			for (const double velocity : { 0.0, 1e-6, 1.0, 100.0 }) {
				const MotorLog<double> log{ glm::normalize(random.vector(1.0)) * angle, random.vector(velocity), dilation };
				worst = std::max(worst, error_of_exp(to_multivector(log)));
			}
		}
	}
	CHECK(worst < 1e-13);
}

TEST_CASE("a small dilation keeps its precision next to a rotation") {
	for (const double dilation : { 1e-12, -1e-9, 1e-300 }) {
		const Multivector motor = *exp(to_multivector(MotorLog<double>{ { 0.0, 0.0, 1.0 }, {}, dilation }));
		// e45: -sinh(sigma / 2) cos(theta / 2).
		CHECK(motor[blade_index("e45")] == doctest::Approx(-0.5 * dilation * std::cos(0.5)).epsilon(1e-15));
	}
}

TEST_CASE("exp of random bivectors") {
	Random random(102);
	for (const double size : { 1e-9, 1e-3, 0.1, 0.5, 1.0, 3.0 }) {
		double worst = 0.0;
		for (int repeat = 0; repeat < 400; ++repeat) {
			worst = std::max(worst, error_of_exp(random.multivector().grade(2) * size));
		}
		CAPTURE(size);
		CHECK(worst < 1e-13);
	}
}

TEST_CASE("exp of bivectors whose parts are null, equal, or nearly so") {
	Random random(103);
	const char *const pairs[][2] = { { "e12", "e34" }, { "e12", "e35" }, { "e15", "e23" } };
	double worst = 0.0;
	for (int repeat = 0; repeat < 600; ++repeat) {
		const double size = random.uniform(0.0, 4.0);
		const double apart = repeat % 7 == 0 ? 0.0 : std::pow(10.0, random.uniform(-17.0, 0.0));
		const char *const *pair = pairs[repeat % 3];
		Multivector bivector = blade(pair[0]) * size + blade(pair[1]) * (size + apart);
		if (repeat % 4 == 0) {
			bivector = blade("e12") * size + euclidean({ 0.0, 0.0, 1.0 }).outer_product(e_origin()) * (1.0 + apart);
		}
		const Multivector turn = *exp(random.multivector().grade(2) * 0.2);
		bivector = turn.geometric_product(bivector).geometric_product(turn.reverse()).grade(2);
		worst = std::max(worst, error_of_exp(bivector));
	}
	CHECK(worst < 1e-12);
	// Along the axes, where the squares are exact.
	CHECK(error_of_exp(blade("e12") + blade("e34")) < 1e-15);
	CHECK(error_of_exp((blade("e12") + blade("e34")) * 3.0) < 1e-14);
	CHECK(error_of_exp(blade("e12") * 3.0 - blade("e34") * (3.0 + 1e-9)) < 1e-14);
	// Null: the series ends. A transversion.
	const Multivector null = euclidean({ 1.0, 2.0, 3.0 }).outer_product(e_origin());
	CHECK(*exp(null) == Multivector::scalar(1.0) + null);
}

TEST_CASE("exp(B) is a versor of unit weight, with the inverse exp(-B)") {
	Random random(104);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector bivector = random.multivector().grade(2) * random.uniform(0.0, 2.0);
		const Multivector versor = *exp(bivector);
		const double size = versor.max_abs();
		CHECK(versor.geometric_product(versor.reverse()).is_equal_approx(Multivector::scalar(1.0), 1e-13 * (1.0 + size * size)));
		CHECK(exp(-bivector)->is_equal_approx(versor.reverse(), 1e-13 * size));
		const Multivector half = *exp(bivector * 0.5);
		CHECK(half.geometric_product(half).is_equal_approx(versor, 1e-12 * (1.0 + half.max_abs() * half.max_abs())));
	}
}

TEST_CASE("exp of scalars, vectors and arbitrary elements") {
	CHECK(*exp(Multivector()) == Multivector::scalar(1.0));
	CHECK((*exp(Multivector::scalar(2.0)))[0] == doctest::Approx(std::exp(2.0)).epsilon(1e-15));
	// e1^2 = 1, e5^2 = -1, e_inf^2 = 0.
	CHECK(relative_error(*exp(blade("e1") * 2.0), Multivector::scalar(std::cosh(2.0)) + blade("e1") * std::sinh(2.0)) < 1e-14);
	CHECK(relative_error(*exp(blade("e5") * 2.0), Multivector::scalar(std::cos(2.0)) + blade("e5") * std::sin(2.0)) < 1e-14);
	CHECK(relative_error(*exp(e_infinity()), Multivector::scalar(1.0) + e_infinity()) < 1e-15);
	// I commutes and squares to -1.
	CHECK(relative_error(*exp(blade("I") * PI), Multivector::scalar(-1.0)) < 1e-13);
	Random random(105);
	double worst = 0.0;
	for (int repeat = 0; repeat < 500; ++repeat) {
		worst = std::max(worst, error_of_exp(random.multivector() * random.uniform(0.0, 1.0)));
	}
	CHECK(worst < 1e-12);
	const Multivector bivector = random.multivector().grade(2);
	CHECK(relative_error(*exp(bivector + Multivector::scalar(0.7)), *exp(bivector) * std::exp(0.7)) < 1e-15);
}

TEST_CASE("an exponential beyond double is an error, never infinity") {
	for (const char *name : { "e45", "e15", "e1", "1", "I" }) {
		CAPTURE(name);
		for (const double size : { 10.0, 800.0, 1e10, 1e160, 1e308 }) {
			const MultivectorResult result = exp(blade(name) * size);
			CHECK((result.has_value() ? result->is_finite() : describe(result.error())[0] != '\0'));
		}
	}
	CHECK_FALSE(exp(blade("e45") * 800.0));
	CHECK_FALSE(exp(blade("1") * 710.0));
	CHECK_FALSE(exp(blade("e1") * std::numeric_limits<double>::quiet_NaN()));
	CHECK_FALSE(exp(blade("e12") * std::numeric_limits<double>::infinity()));
	// Scales beyond double whose motor is within it.
	CHECK(relative_error(*exp(blade("e45") * 500.0), Multivector::scalar(std::cosh(500.0)) + blade("e45") * std::sinh(500.0)) < 1e-13);
}
