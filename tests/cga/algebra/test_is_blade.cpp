#include "cga/algebra/is_blade.hpp"

#include "../random_poses.hpp"
#include "cga/algebra/null_basis.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace cga;
using cga_test::Random;

namespace {

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

Multivector random_blade(Random &random, int grade) {
	Multivector product = Multivector::scalar(random.normal());
	for (int factor = 0; factor < grade; ++factor) {
		product = product.outer_product(random.multivector().grade(1));
	}
	return product;
}

} // namespace

TEST_CASE("outer products of vectors are blades, at any size; null ones too") {
	Random random(41);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const int k = repeat % 6;
		const Multivector x = random_blade(random, k) * std::pow(10.0, random.uniform(-200.0, 200.0));
		CHECK(is_blade(x));
		CHECK(single_grade(x) == k);
		CHECK(is_blade(x.dual()));
	}
	CHECK(is_blade(e_infinity()));
	CHECK(is_blade(blade("e1").outer_product(e_infinity())));
	CHECK(is_blade(Multivector()));
	CHECK(is_blade(blade("e1") * 5e-324));
}

TEST_CASE("sums of blades are not blades, except in grades 0, 1, 4 and 5") {
	Random random(42);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const Multivector x = random.multivector();
		CHECK(is_blade(x.grade(0)));
		CHECK(is_blade(x.grade(1)));
		CHECK_FALSE(is_blade(x.grade(2)));
		CHECK_FALSE(is_blade(x.grade(3)));
		CHECK(is_blade(x.grade(4)));
		CHECK(is_blade(x.grade(5)));
		CHECK_FALSE(is_blade(x));
		CHECK_FALSE(is_blade(x.grade(1) + x.grade(2)));
	}
	CHECK_FALSE(is_blade((blade("e12") + blade("e34")) * 1e-150));
	CHECK_FALSE(is_blade((blade("e123") + blade("e145")) * 1e150));
	CHECK_FALSE(is_blade(blade("e12") * std::numeric_limits<double>::quiet_NaN()));
	CHECK_FALSE(is_blade(blade("e12") * std::numeric_limits<double>::infinity()));
}

TEST_CASE("the tolerance is relative to the size") {
	const Multivector nearly = blade("e12") + blade("e34") * 1e-6;
	for (const double size : { 1e-100, 1.0, 1e100 }) {
		CHECK_FALSE(is_blade(nearly * size));
		CHECK(is_blade(nearly * size, 1e-5));
		CHECK(is_blade((blade("e12") + blade("e3") * 1e-11) * size));
		CHECK_FALSE(is_blade((blade("e12") + blade("e3") * 1e-9) * size));
	}
	CHECK_FALSE(single_grade(Multivector()).has_value());
	CHECK_FALSE(single_grade(blade("e1") + blade("e12")).has_value());
}
