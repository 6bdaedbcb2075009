#include "cga/versor/normalized.hpp"

#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/versor/is_versor.hpp"
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

Multivector normalized_or_fail(const Multivector &x) {
	const MultivectorResult result = normalized(x);
	REQUIRE_MESSAGE(result, describe(result.error()));
	return *result;
}

} // namespace

TEST_CASE("versors and blades of any size are scaled to norm 1") {
	Random random(141);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		const Multivector versor = random_product(random, repeat % 6);
		const double size = std::pow(10.0, random.uniform(-200.0, 200.0)) * (repeat % 2 == 0 ? 1.0 : -1.0);
		const Multivector unit = normalized_or_fail(versor * size);
		CHECK(std::abs(unit.norm_squared()) == doctest::Approx(1.0).epsilon(1e-12 * (1.0 + versor.max_abs() * versor.max_abs())));
		CHECK(relative_error(unit, versor * (size > 0.0 ? 1.0 : -1.0)) < 1e-11 * (1.0 + versor.max_abs() * versor.max_abs()));
		CHECK(is_versor(unit));
	}
	CHECK(normalized_or_fail(blade("e5") * -4.0) == -blade("e5"));
	CHECK(normalized_or_fail(Multivector::scalar(-4.0)) == Multivector::scalar(-1.0));
}

TEST_CASE("noisy motors become the nearest motor of unit weight, as in Motor::normalized") {
	Random random(142);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const double noise = std::pow(10.0, random.uniform(-14.0, -2.0));
		const Motor<double> motor = Motor<double>::from_pose({ random.vector(1.0), random.rotation(), random.uniform(0.5, 2.0) });
		const auto shake = [&](const QuaternionD &q) { return q + QuaternionD(random.normal(), random.normal(), random.normal(), random.normal()) * noise; };
		const Motor<double> noisy{ shake(motor.a), shake(motor.b), shake(motor.v) };
		const Multivector unit = normalized_or_fail(to_multivector(noisy) * random.uniform(0.1, 10.0));
		CHECK(unit.is_equal_approx(to_multivector(*noisy.normalized()), 1e-11));
		CHECK(unit.is_equal_approx(to_multivector(motor), 100.0 * noise + 1e-11));
		CHECK(is_motor(unit));
		CHECK(unit.norm_squared() == doctest::Approx(1.0).epsilon(1e-12));
	}
}

TEST_CASE("noisy versors, odd and even, of either sign of X X~, become nearby versors") {
	Random random(143);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const int factors = 1 + repeat % 4;
		const Multivector versor = random_product(random, factors);
		const Multivector noise = random.multivector() * 1e-4;
		const Multivector noisy = versor + (factors % 2 == 0 ? noise + noise.grade_involution() : noise - noise.grade_involution()) * 0.5;
		const Multivector unit = normalized_or_fail(noisy);
		CHECK(is_versor(unit, 1e-9));
		CHECK(unit.norm_squared() == doctest::Approx(versor.norm_squared()).epsilon(1e-9 * (1.0 + std::pow(unit.max_abs(), 2.0))));
		CHECK(relative_error(unit, versor) < 1e-2 * (1.0 + versor.max_abs() * versor.max_abs()));
	}
}

TEST_CASE("any other element gets norm 1 or an error, never infinity") {
	Random random(144);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		Multivector x = random.multivector();
		x = repeat % 3 == 0 ? x.grade(2) : repeat % 3 == 1 ? x + x.grade_involution()
														   : x;
		const MultivectorResult unit = normalized(x);
		if (!unit) {
			CHECK(x.norm() < 1e-6);
			continue;
		}
		CHECK(unit->is_finite());
		CHECK(unit->norm() == doctest::Approx(1.0).epsilon(1e-12 * (1.0 + unit->max_abs() * unit->max_abs())));
	}
	CHECK(normalized_or_fail(blade("e12") + blade("e34")).is_equal_approx((blade("e12") + blade("e34")) * std::sqrt(0.5), 1e-15));
}

TEST_CASE("null elements are reported as an error, at any size and position") {
	Random random(145);
	for (int repeat = 0; repeat < 500; ++repeat) {
		const double size = std::pow(10.0, random.uniform(-200.0, 200.0));
		const Multivector position = point(random.vector(std::pow(10.0, random.uniform(-3.0, 5.0))));
		for (const Multivector &null : { position, e_infinity(), euclidean(random.vector(1.0)).outer_product(e_infinity()), position + position.dual() }) {
			const MultivectorResult result = normalized(null * size);
			REQUIRE_FALSE(result);
			CHECK(result.error() == AlgebraError::NULL_HAS_NO_NORM);
		}
	}
	CHECK(normalized(Multivector()).error() == AlgebraError::ZERO_HAS_NO_NORM);
	CHECK_FALSE(normalized(blade("e1") * std::numeric_limits<double>::infinity()));
	CHECK_FALSE(normalized(blade("e1") * std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("the smallest and the largest elements, and motors with large translations") {
	CHECK(normalized_or_fail(blade("e1") * 5e-324) == blade("e1"));
	CHECK(normalized_or_fail(blade("e1") * 1.7e308).is_equal_approx(blade("e1"), 1e-15));
	const Multivector far = translator({ 1e12, 0.0, 3e11 });
	CHECK(relative_error(normalized_or_fail(far * 5.0), far) < 1e-15);
}
