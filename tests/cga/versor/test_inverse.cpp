#include "cga/versor/inverse.hpp"

#include "../random_poses.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace cga;
using cga_test::Random;

namespace {

const Multivector ONE = Multivector::scalar(1.0);

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

// The deviation of X X^-1 and X^-1 X from 1, relative to the sizes of both.
double error_of_inverse(const Multivector &x) {
	const MultivectorResult result = inverse(x);
	REQUIRE_MESSAGE(result, describe(result.error()));
	const double size = x.max_abs() * result->max_abs();
	return std::max((x.geometric_product(*result) - ONE).max_abs(), (result->geometric_product(x) - ONE).max_abs()) / size;
}

} // namespace

TEST_CASE("random elements of all grades, whatever their size") {
	Random random(21);
	double worst = 0.0;
	for (int repeat = 0; repeat < 5000; ++repeat) {
		worst = std::max(worst, error_of_inverse(random.multivector() * std::pow(10.0, random.uniform(-120.0, 120.0))));
	}
	CHECK(worst < 1e-13);
}

TEST_CASE("elements of some grades that are not versors") {
	Random random(22);
	double worst = 0.0;
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector x = random.multivector();
		worst = std::max(worst, error_of_inverse(x.grade(2)));
		worst = std::max(worst, error_of_inverse(x.grade(3)));
		worst = std::max(worst, error_of_inverse(x.grade(0) + x.grade(2) + x.grade(4)));
		worst = std::max(worst, error_of_inverse(x.grade(1) + x.grade(3) + x.grade(5)));
		worst = std::max(worst, error_of_inverse(x.grade(0) + x.grade(1)));
	}
	CHECK(worst < 1e-12);
}

TEST_CASE("the inverse of versors is X~ / (X X~)") {
	Random random(23);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		Multivector versor = Multivector::scalar(random.scale());
		for (int factor = 0; factor < repeat % 5; ++factor) {
			versor = versor.geometric_product(random.multivector().grade(1));
		}
		const MultivectorResult result = inverse(versor);
		REQUIRE(result);
		const double weight = versor.norm_squared();
		CHECK(result->is_equal_approx(versor.reverse() * (1.0 / weight), 1e-9 * result->max_abs()));
	}
}

TEST_CASE("known inverses") {
	// (1 + 2 e1)(1 - 2 e1) = -3.
	CHECK(inverse(ONE + blade("e1") * 2.0)->is_equal_approx((ONE - blade("e1") * 2.0) * (-1.0 / 3.0), 1e-15));
	// (e12 + 2 e34)(2 e34 - e12) = 1 - 4.
	CHECK(inverse(blade("e12") + blade("e34") * 2.0)->is_equal_approx((blade("e34") * 2.0 - blade("e12")) * (-1.0 / 3.0), 1e-15));
	CHECK(*inverse(blade("I")) == -blade("I"));
	CHECK(*inverse(blade("e5")) == -blade("e5"));
	CHECK(*inverse(Multivector::scalar(-4.0)) == Multivector::scalar(-0.25));
}

TEST_CASE("motors with large translations have an inverse") {
	for (const double distance : { 1.0, 1e5, 1e9, 1e12 }) {
		const Multivector motor = translator({ distance, -2.0 * distance, 0.0 }).geometric_product(rotor({ 0.6, 0.0, 0.8, 0.0 }));
		const MultivectorResult result = inverse(motor);
		REQUIRE(result);
		CHECK(result->is_equal_approx(motor.reverse(), 1e-14 * distance));
	}
}

TEST_CASE("the inverse of the inverse, of a product, of the dual") {
	Random random(24);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Multivector a = random.multivector();
		const Multivector b = random.multivector();
		const Multivector inverse_a = *inverse(a);
		const Multivector inverse_b = *inverse(b);
		const double condition = a.max_abs() * inverse_a.max_abs() * b.max_abs() * inverse_b.max_abs();
		CHECK(inverse(inverse_a)->is_equal_approx(a, 1e-12 * condition));
		CHECK(inverse(a.geometric_product(b))->is_equal_approx(inverse_b.geometric_product(inverse_a), 1e-11 * condition * inverse_a.max_abs() * inverse_b.max_abs()));
		CHECK(inverse(a.dual())->is_equal_approx(-inverse_a.dual(), 1e-12 * condition));
	}
}

TEST_CASE("singular elements are detected at any size and in any product") {
	const Multivector singular_elements[] = { ONE + blade("e1"), ONE + blade("e45"), blade("e12") + blade("e34"), e_infinity(), e_origin(),
		blade("e1").outer_product(e_infinity()), point({ 1.0, 2.0, 3.0 }), ONE + blade("e1234") };
	Random random(25);
	for (const Multivector &singular : singular_elements) {
		for (int repeat = 0; repeat < 200; ++repeat) {
			const double size = std::pow(10.0, random.uniform(-250.0, 250.0));
			CHECK_FALSE(inverse(singular * size));
			CHECK_FALSE(inverse(random.multivector().geometric_product(singular)));
			CHECK_FALSE(inverse(singular.geometric_product(random.multivector())));
		}
	}
	CHECK(inverse(ONE + blade("e1")).error() == AlgebraError::SINGULAR);
}

TEST_CASE("nearly singular elements keep their significant digits") {
	for (const double apart : { 1e-3, 1e-6, 1e-9 }) {
		// (1 + a e1)(1 - a e1) = 1 - a^2.
		const double a = 1.0 - apart;
		const Multivector expected = (ONE - blade("e1") * a) * (1.0 / (apart * (2.0 - apart)));
		CHECK(inverse(ONE + blade("e1") * a)->is_equal_approx(expected, 1e-15 / apart * expected.max_abs()));
	}
	CHECK_FALSE(inverse(ONE + blade("e1") * (1.0 - 1e-15)));
}

TEST_CASE("zero, infinity, the smallest and the largest") {
	CHECK(inverse(Multivector()).error() == AlgebraError::ZERO_HAS_NO_INVERSE);
	CHECK_FALSE(inverse(blade("e1") * std::numeric_limits<double>::infinity()));
	CHECK_FALSE(inverse(blade("e1") * std::numeric_limits<double>::quiet_NaN()));
	CHECK(inverse(blade("e1") * 5e-324).error() == AlgebraError::INVERSE_OVERFLOW);
	CHECK(inverse(blade("e1") * 1e308)->is_equal_approx(blade("e1") * 1e-308, 1e-320));
}
