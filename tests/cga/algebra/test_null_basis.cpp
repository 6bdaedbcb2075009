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
