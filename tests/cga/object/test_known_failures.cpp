#include "cga/object/classify.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

// Known errors of other libraries and the GA-Unity paper in objects; tests/cga/versor/test_known_failures.cpp has those in motors.

using namespace cga;
using namespace cga_test;

namespace {

constexpr int CASES = 1000;

} // namespace

TEST_CASE("crossing lines meet in a point (zero by the fixed pseudoscalar)") {
	Random random(171);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D p = random.vector(3.0), u = glm::normalize(random.vector(1.0));
		const Vector3D v = glm::normalize(glm::cross(u, random.vector(1.0)));
		const Multivector a = *line(p - u, u), b = *line(p + 2.0 * v, v);
		CHECK(a.regressive_product(b).max_abs() < 1e-14 * (1.0 + glm::dot(p, p)));
		const MultivectorResult shared = meet(a, b);
		REQUIRE(shared);
		const Classification found = classify(*shared);
		CHECK(found.kind == Kind::FLAT_POINT);
		REQUIRE(found.center);
		CHECK(glm::length(*found.center - p) < 1e-12);
	}
}

TEST_CASE("the radius is sqrt(S1^2 + S2^2 + S3^2 - (S4 + S5)) for S5 - S4 = 1 (twice that difference in the paper)") {
	Random random(172);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D c = random.vector(2.0);
		const double radius = random.uniform(0.1, 3.0);
		const Multivector dual = sphere(c, radius)->dual();
		const Multivector s = dual * (1.0 / (dual[E5] - dual[E4]));
		const double squares = s[E1] * s[E1] + s[E2] * s[E2] + s[E3] * s[E3];
		CHECK(std::sqrt(squares - (s[E4] + s[E5])) == doctest::Approx(radius).epsilon(1e-10));
		CHECK(std::abs(squares - 2.0 * (s[E4] + s[E5]) - radius * radius) == doctest::Approx(std::abs(s[E4] + s[E5])).epsilon(1e-9));
		CHECK(*classify(s, true).radius == doctest::Approx(radius).epsilon(1e-10));
	}
}

TEST_CASE("planes, spheres and circles have their names (clifford's interpret_multivector_as_object misnames them)") {
	Random random(173);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D p = random.vector(2.0), n = glm::normalize(random.vector(1.0));
		const double radius = random.uniform(0.1, 3.0);
		CHECK(classify(*plane(n, radius)).kind == Kind::PLANE);
		CHECK(classify(plane(n, radius)->dual(), true).kind == Kind::PLANE);
		CHECK(classify(*sphere(p, radius)).kind == Kind::SPHERE);
		CHECK(classify(sphere(p, radius)->dual(), true).kind == Kind::SPHERE);
		CHECK(classify(*circle(p, n, radius)).kind == Kind::CIRCLE);
		CHECK(classify(circle(p, n, radius)->dual(), true).kind == Kind::CIRCLE);
	}
}

TEST_CASE("one element is a pair in OPNS and a circle in IPNS (grade alone cannot tell)") {
	const Multivector pair = *point_pair({ 0, 0, -1 }, { 0, 0, 1 });
	CHECK(classify(pair).kind == Kind::POINT_PAIR);
	const Classification circle_of = classify(pair, true);
	CHECK(circle_of.kind == Kind::CIRCLE);
	CHECK(circle_of.imaginary);
	CHECK(*circle_of.radius == doctest::Approx(1.0));
}
