#include "cga/versor/is_versor.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "random_versors.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace cga;
using namespace cga_test;

namespace {

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

} // namespace

TEST_CASE("products of mirrors are versors at any size") {
	Random random(131);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		const Multivector versor = random_product(random, repeat % 6);
		CHECK(is_versor(versor * std::pow(10.0, random.uniform(-150.0, 150.0))));
		CHECK(is_versor(versor.dual()));
	}
	CHECK(is_versor(Multivector::scalar(-2.0)));
	CHECK(is_versor(blade("I")));
}

TEST_CASE("a versor maps vectors to vectors; other elements are not versors") {
	Random random(132);
	int versors = 0;
	for (int repeat = 0; repeat < 3000; ++repeat) {
		// Bivectors, simple or not: only simple ones are versors.
		const Multivector x = repeat % 2 == 0 ? random.multivector().grade(1).outer_product(random.multivector().grade(1)) : random.multivector().grade(2);
		const Multivector image = x.geometric_product(random.multivector().grade(1)).geometric_product(x.reverse());
		const bool carries = (image - image.grade(1)).max_abs() < 1e-9 * image.max_abs();
		CHECK(is_versor(x) == carries);
		versors += carries ? 1 : 0;
	}
	CHECK(versors == 1500);
}

TEST_CASE("null elements, elements of mixed parity and invalid ones are not versors") {
	Random random(133);
	for (const Multivector &x : { Multivector(), e_infinity(), e_origin(), point({ 1.0, 2.0, 3.0 }), blade("e1").outer_product(e_infinity()),
				 blade("1") + blade("e1"), blade("1") + blade("e45"), blade("e12") + blade("e34"), blade("e1") * std::numeric_limits<double>::infinity(),
				 blade("e1") * std::numeric_limits<double>::quiet_NaN() }) {
		CHECK_FALSE(is_versor(x));
		CHECK_FALSE(is_motor(x));
	}
	for (int repeat = 0; repeat < 1000; ++repeat) {
		CHECK_FALSE(is_versor(random.multivector()));
		CHECK_FALSE(is_versor(random_product(random, 2) + random_product(random, 3)));
	}
}

TEST_CASE("motors of any weight and translation are motors and versors; other versors are not motors") {
	Random random(134);
	for (int repeat = 0; repeat < 2000; ++repeat) {
		const double distance = std::pow(10.0, random.uniform(-6.0, 12.0));
		const Multivector motor = to_multivector(Motor<double>::from_pose(random.pose(distance))) * std::pow(10.0, random.uniform(-50.0, 50.0));
		CHECK(is_motor(motor));
		CHECK(is_motor(-motor));
		CHECK(is_versor(motor));
		CHECK_FALSE(is_motor(random_product(random, 1 + repeat % 4)));
		CHECK_FALSE(is_motor(transversion(random.vector(1.0))));
	}
}

TEST_CASE("the tolerance is relative") {
	for (const double size : { 1e-100, 1.0, 1e100 }) {
		const Multivector noisy = (blade("1") + blade("e1234") * 1e-6) * size;
		CHECK_FALSE(is_versor(noisy));
		CHECK(is_versor(noisy, 1e-5));
		CHECK_FALSE(is_versor((blade("1") + blade("e1") * 1e-9) * size));
		CHECK(is_versor((blade("1") + blade("e1") * 1e-11) * size));
	}
}
