#include "cga/typed/sparse.hpp"

#include "cga/typed/motion.hpp"
#include "cga/typed/objects.hpp"
#include "random_typed.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace cga;
using namespace cga::typed;
using namespace cga_test;

namespace {

constexpr int CASES = 2000;

template <class Left, class Right>
void check_products(Random &random) {
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Left a = random_element<Left>(random);
		const Right b = random_element<Right>(random);
		const Multivector x = a.to_multivector(), y = b.to_multivector();
		CHECK(difference(a.geometric_product(b), x.geometric_product(y)) < 1e-14);
		CHECK(difference(a.outer_product(b), x.outer_product(y)) < 1e-14);
		CHECK(difference(a.inner_product(b), x.inner_product(y)) < 1e-14);
		CHECK(difference(a.left_contraction(b), x.left_contraction(y)) < 1e-14);
		CHECK(difference(a.right_contraction(b), x.right_contraction(y)) < 1e-14);
		CHECK(difference(a.commutator_product(b), x.commutator_product(y)) < 1e-14);
		CHECK(difference(a.regressive_product(b), x.regressive_product(y)) < 1e-14);
		CHECK(std::abs(a.scalar_product(b) - x.scalar_product(y)) < 1e-14 * std::max(1.0, x.max_abs() * y.max_abs()));
	}
}

template <class Element>
void check_alone(Random &random) {
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Element a = random_element<Element>(random), b = random_element<Element>(random);
		const Multivector x = a.to_multivector(), y = b.to_multivector();
		CHECK(difference(a + b, x + y) < 1e-15);
		CHECK(difference(a - b * 3.0, x - y * 3.0) < 1e-14);
		CHECK(difference(-a, -x) == 0.0);
		CHECK(difference(a.reverse(), x.reverse()) == 0.0);
		CHECK(difference(a.grade_involution(), x.grade_involution()) == 0.0);
		CHECK(difference(a.dual(), x.dual()) < 1e-15);
		CHECK(difference(a.undual(), x.undual()) < 1e-15);
		CHECK(difference(a.dual().undual(), x) == 0.0);
		const std::optional<Element> back = Element::from(x);
		REQUIRE(back);
		CHECK(difference(*back, x) < 1e-15);
		// An element with other coefficients does not convert.
		const Multivector other = random.multivector();
		CHECK_FALSE(Element::from(x + other));
		CHECK(Element::from(x + other * 1e-13, 1e-10));
	}
}

} // namespace

TEST_CASE("products of any two types agree with Multivector's") {
	Random random(61);
	check_products<Point<>, Point<>>(random);
	check_products<Point<>, PointPair<>>(random);
	check_products<PointPair<>, Circle<>>(random);
	check_products<Circle<>, Circle<>>(random);
	check_products<Sphere<>, Sphere<>>(random);
	check_products<Sphere<>, Circle<>>(random);
	check_products<Line<>, Plane<>>(random);
	check_products<Line<>, Sphere<>>(random);
	check_products<FlatPoint<>, Line<>>(random);
	check_products<Plane<>, Plane<>>(random);
	check_products<Versor<>, Versor<>>(random);
	check_products<Versor<>, Circle<>>(random);
}

TEST_CASE("sums, signs, duals and conversions agree with Multivector's") {
	Random random(62);
	check_alone<Point<>>(random);
	check_alone<PointPair<>>(random);
	check_alone<Circle<>>(random);
	check_alone<Sphere<>>(random);
	check_alone<FlatPoint<>>(random);
	check_alone<Line<>>(random);
	check_alone<Plane<>>(random);
	check_alone<Versor<>>(random);
}

TEST_CASE("types store only their coefficients, and products have only the terms that they need") {
	CHECK(Point<>::SIZE == 5);
	CHECK(PointPair<>::SIZE == 10);
	CHECK(Circle<>::SIZE == 10);
	CHECK(Sphere<>::SIZE == 5);
	CHECK(FlatPoint<>::SIZE == 4);
	CHECK(Line<>::SIZE == 6);
	CHECK(Plane<>::SIZE == 4);
	CHECK(Versor<>::SIZE == 12);
	CHECK(sizeof(Line<float>) == 6 * sizeof(float));
	CHECK(Kernel<Product::SCALAR, Point<>::BLADES, Point<>::BLADES, 1u>::COUNT == 5);
	CHECK(Kernel<Product::OUTER, Point<>::BLADES, Point<>::BLADES, PointPair<>::BLADES>::COUNT == 20);
	// The square of e_inf is zero: three points and e_inf make a plane of four coefficients.
	const auto plane = Point<>().outer_product(Point<>()).outer_product(Point<>()).outer_product(infinity());
	CHECK(plane.BLADES == Plane<>::BLADES);
	CHECK(infinity().outer_product(Line<>()).SIZE == 0);
	// Products are constant expressions.
	constexpr double MINUS_ONE = infinity().scalar_product(dual_sphere(Vector3D(3.0, 4.0, 5.0), 2.0));
	CHECK(MINUS_ONE == -1.0);
}

TEST_CASE("elements that are not finite do not convert") {
	Multivector x = Multivector::basis_blade(E1);
	x[E1] = std::numeric_limits<double>::quiet_NaN();
	CHECK_FALSE(Point<>::from(x));
	CHECK(Point<>::from(Multivector()));
}
