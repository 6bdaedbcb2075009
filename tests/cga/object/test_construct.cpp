#include "cga/object/construct.hpp"

#include "../random_poses.hpp"
#include "cga/algebra/is_blade.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace cga;
using namespace cga_test;

namespace {

constexpr int CASES = 1000;
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// The largest difference of coefficients, relative to the largest coefficient of `wanted`.
double difference(const MultivectorResult &x, const Multivector &wanted) {
	REQUIRE_MESSAGE(x, describe(x.error()));
	return (*x - wanted).max_abs() / wanted.max_abs();
}

bool rejected(const MultivectorResult &x) {
	return !x && !std::string(describe(x.error())).empty();
}

} // namespace

TEST_CASE("objects through points are the outer products of the points") {
	Random random(1);
	for (int i = 0; i < CASES; ++i) {
		const Vector3D a = random.vector(1.0), b = random.vector(1.0), c = random.vector(1.0), d = random.vector(1.0);
		const Multivector two = point(a).outer_product(point(b)), three = two.outer_product(point(c));
		CHECK(difference(point_pair(a, b), two) < 1e-14);
		CHECK(difference(line_through(a, b), two.outer_product(e_infinity())) < 1e-14);
		CHECK(difference(circle_through(a, b, c), three) < 1e-11);
		CHECK(difference(plane_through(a, b, c), three.outer_product(e_infinity())) < 1e-13);
		CHECK(difference(sphere_through(a, b, c, d), three.outer_product(point(d))) < 1e-9);
		CHECK(difference(flat_point(a), point(a).outer_product(e_infinity())) < 1e-15);
	}
}

TEST_CASE("points on an object have outer product zero with it") {
	Random random(2);
	for (int i = 0; i < CASES; ++i) {
		const Vector3D center = random.vector(1.0), normal = glm::normalize(random.vector(1.0));
		const double radius = random.uniform(0.1, 3.0);
		const Vector3D across = glm::normalize(glm::cross(normal, random.vector(1.0)));
		CHECK(point(center + across * radius).outer_product(*circle(center, normal, radius)).max_abs() < 1e-11);
		CHECK(point(center + normal * radius).outer_product(*sphere(center, radius)).max_abs() < 1e-11);
		CHECK(point(center + normal * 5.0).outer_product(*line(center, normal)).max_abs() < 1e-12);
		CHECK(point(center + across).outer_product(*plane(normal, glm::dot(normal, center))).max_abs() < 1e-12);
		CHECK(point(center + across * radius).outer_product(*imaginary_circle(center, normal, radius)).max_abs() > 1e-3 * radius * radius);
		CHECK(is_blade(*circle(center, normal, radius)));
		CHECK(is_blade(*imaginary_point_pair(center, normal, radius)));
		CHECK(is_blade(*tangent_across(center, normal)));
	}
}

TEST_CASE("a sphere through nearly coplanar points, however large, stays near them") {
	for (double height = 1.0; height > 1e-8; height *= 0.1) {
		const Vector3D a(0.4, 0.3, 0.0), b(1.0, 0.1, 0.0), c(0.3, 1.1, 0.0), d(-0.7, 0.6, height);
		const MultivectorResult through = sphere_through(a, b, c, d);
		REQUIRE(through);
		const Multivector sphere = *through * (1.0 / through->max_abs());
		for (const Vector3D &on : { a, b, c, d }) {
			// Of unit size, near the points a large sphere is nearly a plane: these are distances.
			CHECK(point(on).outer_product(sphere).max_abs() < 1e-14);
		}
	}
}

TEST_CASE("points of a line, of a plane and of a circle") {
	CHECK(difference(circle_through({ 0, 0, 0 }, { 1, 0, 0 }, { 3, 0, 0 }), *line_through({ 0, 0, 0 }, { 3, 0, 0 })) == 0.0);
	CHECK(rejected(plane_through({ 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 })));
	const Vector3D a(0, 0, 2), b(1, 0, 2), c(0, 1, 2), d(3, 3, 2);
	CHECK(difference(sphere_through(a, b, c, d), point(a).outer_product(point(b)).outer_product(point(c)).outer_product(point(d))) < 1e-13);
	CHECK(rejected(sphere_through({ 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 })));
	CHECK(rejected(sphere_through({ 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 })));
}

TEST_CASE("degenerate and invalid input is rejected with the reason") {
	const Vector3D a(1, 2, 3), zero(0, 0, 0), broken(NOT_A_NUMBER, 0, 0);
	CHECK(rejected(flat_point(broken)));
	CHECK(rejected(point_pair(a, a)));
	CHECK(rejected(line(a, zero)));
	CHECK(rejected(line(a, broken)));
	CHECK(rejected(line_through(a, a)));
	CHECK(rejected(circle(a, zero, 1.0)));
	CHECK(rejected(circle(a, a, 0.0)));
	CHECK(rejected(circle(a, a, -1.0)));
	CHECK(rejected(circle(a, a, NOT_A_NUMBER)));
	CHECK(rejected(circle_through(a, a, zero)));
	CHECK(rejected(plane(zero, 1.0)));
	CHECK(rejected(plane(a, NOT_A_NUMBER)));
	CHECK(rejected(sphere(a, 0.0)));
	CHECK(rejected(sphere(broken, 1.0)));
	CHECK(rejected(sphere({ 1e200, 0, 0 }, 1.0)));
	CHECK(rejected(imaginary_sphere(a, 0.0)));
	CHECK(rejected(tangent_along(a, zero)));
	CHECK(rejected(tangent_across(broken, a)));
	CHECK(rejected(direction(zero)));
	CHECK(rejected(direction_across(broken)));
}
