#include "cga/versor/power.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
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

Multivector power_of(const Multivector &versor, double exponent) {
	const MultivectorResult result = power(versor, exponent);
	REQUIRE_MESSAGE(result, describe(result.error()));
	return *result;
}

// Errors of products are relative to the sizes of the factors.
double size_of(const Multivector &left, const Multivector &right) {
	return 1.0 + left.max_abs() * right.max_abs();
}

} // namespace

TEST_CASE("powers of motors over the grid, against the exponential of the multiple of the bivector") {
	Random random(121);
	double worst = 0.0;
	for (const double angle : { 0.0, 1e-12, 1e-6, 0.1, 1.0, 3.0, PI - 1e-6, PI - 1e-12 }) {
		for (const double dilation : { 0.0, 1e-12, -1e-12, 0.01, -1.0, 5.0, -5.0 }) {
			for (const double exponent : { -1.0, -0.3, 0.0, 1e-6, 0.5, 1.0, 1.7 }) {
				const Multivector bivector = to_multivector(MotorLog<double>{ glm::normalize(random.vector(1.0)) * angle, random.vector(5.0), dilation });
				const Multivector expected = *exp(bivector * exponent);
				worst = std::max(worst, relative_error(power_of(*exp(bivector), exponent), expected));
			}
		}
	}
	CHECK(worst < 1e-13);
}

TEST_CASE("powers add") {
	Random random(122);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector versor = repeat % 2 == 0 ? random_even_versor(random) : to_multivector(Motor<double>::from_pose(random.pose(2.0)));
		const double a = random.uniform(-1.0, 1.0);
		const double b = random.uniform(-1.0, 1.0);
		const Multivector of_a = power_of(versor, a);
		const Multivector of_b = power_of(versor, b);
		CHECK(of_a.geometric_product(of_b).is_equal_approx(power_of(versor, a + b), 1e-11 * size_of(of_a, of_b)));
	}
}

TEST_CASE("the square root is power 1/2; its square is the versor, or minus it where the scalar part is negative") {
	Random random(123);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const double weight = std::pow(10.0, random.uniform(-3.0, 3.0));
		const Multivector versor = (repeat % 2 == 0 ? random_even_versor(random) : to_multivector(Motor<double>::from_pose(random.pose(2.0)))) * weight;
		const MultivectorResult root = cga::sqrt(versor);
		REQUIRE(root);
		CHECK(*root == power_of(versor, 0.5));
		const Multivector expected = versor[0] < 0.0 ? -versor : versor;
		CHECK(root->geometric_product(*root).is_equal_approx(expected, 1e-12 * (weight + root->max_abs() * root->max_abs())));
	}
}

TEST_CASE("the square root of a unit versor of positive scalar part is normalize(1 + M)") {
	Random random(124);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		Multivector versor = repeat % 2 == 0 ? random_even_versor(random) : to_multivector(Motor<double>::from_pose(random.pose(2.0)));
		versor = versor[0] < 0.0 ? -versor : versor;
		const Multivector root = *cga::sqrt(versor);
		const Multivector sum = *normalized(Multivector::scalar(1.0) + versor);
		CHECK(sum.is_equal_approx(root, 1e-9 * (1.0 + versor.max_abs() * versor.max_abs())));
	}
}

TEST_CASE("integer powers are products, also of odd versors") {
	Random random(125);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Multivector versor = random_product(random, 1 + repeat % 4);
		const Multivector square = versor.geometric_product(versor);
		const Multivector cube = square.geometric_product(versor);
		const double size = 1.0 + std::pow(versor.max_abs(), 3.0);
		CHECK(relative_error_up_to_sign(power_of(versor, 2.0), square) < 1e-10 * size);
		CHECK(relative_error_up_to_sign(power_of(versor, 3.0), cube) < 1e-10 * size);
		CHECK(relative_error_up_to_sign(power_of(versor, -1.0), *inverse(versor)) < 1e-10 * size);
	}
	CHECK(power_of(blade("e1") * 2.0, 3.0) == blade("e1") * 8.0);
	CHECK(power_of(blade("e1") * 2.0, 2.0) == blade("1") * 4.0);
	CHECK(power_of(blade("e5") * 2.0, 2.0) == blade("1") * -4.0);
	CHECK(power_of(blade("e5") * 2.0, -1.0) == blade("e5") * -0.5);
	CHECK(power_of(blade("e5"), 0.0) == blade("1"));
	CHECK(power_of(blade("e15"), 2.0) == blade("1"));
	CHECK(power_of(blade("e1"), 999999999.0) == blade("e1"));
}

TEST_CASE("powers of scalars") {
	CHECK((*cga::sqrt(Multivector::scalar(4.0)))[0] == doctest::Approx(2.0).epsilon(1e-15));
	CHECK(power_of(Multivector::scalar(2.0), 10.0)[0] == doctest::Approx(1024.0).epsilon(1e-14));
	CHECK(power_of(Multivector::scalar(1.0), 1e300) == Multivector::scalar(1.0));
}

TEST_CASE("power() reports why a power is not defined") {
	CHECK(cga::sqrt(blade("e1")).error() == AlgebraError::FRACTIONAL_POWER);
	CHECK(power(blade("e15"), 0.3).error() == AlgebraError::FRACTIONAL_POWER);
	CHECK(power(blade("e1"), 1e10).error() == AlgebraError::EXPONENT_TOO_LARGE);
	CHECK(power(e_infinity(), 2.0).error() == AlgebraError::NOT_A_VERSOR);
	CHECK(power(blade("1") + blade("e1"), 2.0).error() == AlgebraError::NOT_A_VERSOR);
	CHECK(power(blade("e12"), std::numeric_limits<double>::quiet_NaN()).error() == AlgebraError::EXPONENT_NOT_FINITE);
	CHECK_FALSE(power(Multivector::scalar(10.0), 1e5));
	CHECK_FALSE(power(blade("e1") * 10.0, 1e5));
	CHECK_FALSE(power(Multivector::scalar(1e300), 1e308));
	CHECK_FALSE(cga::sqrt(Multivector()));
}
