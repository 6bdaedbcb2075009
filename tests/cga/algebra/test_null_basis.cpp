#include "cga/algebra/null_basis.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

using namespace cga;
using cga_test::Random;
using cga_test::Vector3D;

TEST_CASE("the null vectors and Euclidean vectors") {
	CHECK(e_infinity() == Multivector::basis_blade(4) + Multivector::basis_blade(5));
	CHECK(e_origin() == (Multivector::basis_blade(5) - Multivector::basis_blade(4)) * 0.5);
	CHECK(e_infinity().scalar_product(e_origin()) == -1.0);
	CHECK(e_infinity().norm_squared() == 0.0);
	CHECK(e_origin().norm_squared() == 0.0);
	Random random(9);
	for (int repeat = 0; repeat < 200; ++repeat) {
		const Vector3D a = random.vector(3.0);
		const Vector3D b = random.vector(3.0);
		CHECK(euclidean(a).scalar_product(euclidean(b)) == doctest::Approx(glm::dot(a, b)).epsilon(1e-13));
		CHECK(euclidean(a).scalar_product(e_infinity()) == 0.0);
		CHECK(euclidean(a).scalar_product(e_origin()) == 0.0);
	}
}

TEST_CASE("points are null and their distances are inner products") {
	Random random(11);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Vector3D a = random.vector(10.0);
		const Vector3D b = random.vector(10.0);
		const double squared = glm::dot(a - b, a - b);
		CHECK(point(a).scalar_product(point(b)) == doctest::Approx(-0.5 * squared).epsilon(1e-11));
		CHECK(std::abs(point(a).norm_squared()) < 1e-10);
		CHECK(e_infinity().scalar_product(point(a)) == doctest::Approx(-1.0).epsilon(1e-12));
		CHECK(glm::length(*position_of(point(a) * -3.0) - a) < 1e-12);
	}
	CHECK(point({ 0.0, 0.0, 0.0 }) == e_origin());
	CHECK_FALSE(position_of(e_infinity()).has_value());
}
