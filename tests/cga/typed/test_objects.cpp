#include "cga/typed/objects.hpp"

#include "cga/object/classify.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"
#include "random_typed.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

namespace {

constexpr int CASES = 2000;

// For elements that may differ in weight and sign.
double angle_between_elements(const Multivector &a, const Multivector &b) {
	double aa = 0.0, ab = 0.0, bb = 0.0;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		aa += a[index] * a[index];
		ab += a[index] * b[index];
		bb += b[index] * b[index];
	}
	const double cosine = ab / std::sqrt(aa * bb);
	return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

} // namespace

TEST_CASE("constructors give the same elements as those of Multivector, with sign and weight") {
	Random random(71);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D p = random.vector(3.0), q = random.vector(3.0), s = random.vector(3.0), n = glm::normalize(random.vector(1.0));
		const double radius = random.uniform(0.1, 3.0);
		CHECK(difference(typed::point(p), point(p)) < 1e-15);
		CHECK(difference(typed::sphere(p, radius), *sphere(p, radius)) < 1e-15);
		CHECK(difference(typed::plane(n, radius), *plane(n, radius)) < 1e-15);
		const auto pair = typed::point(p).outer_product(typed::point(q));
		CHECK(difference(pair, *point_pair(p, q)) < 1e-14);
		CHECK(difference(pair.outer_product(typed::infinity()), *line_through(p, q)) < 1e-14);
		CHECK(difference(pair.outer_product(typed::point(s)), *circle_through(p, q, s)) < 1e-10);
		CHECK(difference(pair.outer_product(typed::point(s)).outer_product(typed::infinity()), *plane_through(p, q, s)) < 1e-13);
	}
}

TEST_CASE("inner products of points are distances, of a point and a dual sphere its power") {
	Random random(72);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D p = random.vector(3.0), q = random.vector(3.0);
		const double radius = random.uniform(0.1, 3.0), squared = glm::dot(p - q, p - q);
		const typed::Point<> a = typed::point(p) * random.scale(), b = typed::point(q) * -random.scale();
		CHECK(typed::squared_distance(a, b) == doctest::Approx(squared).epsilon(1e-11));
		CHECK(glm::length(typed::position_of(b) - q) < 1e-14);
		const double power = -2.0 * typed::point(p).scalar_product(typed::dual_sphere(q, radius));
		CHECK(std::abs(power - (squared - radius * radius)) < 1e-12);
	}
}

TEST_CASE("center and radius of rounds, imaginary ones too") {
	Random random(73);
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D p = random.vector(3.0), n = glm::normalize(random.vector(1.0));
		const double radius = random.uniform(0.5, 3.0), weight = random.scale();
		const Multivector rounds[] = { *circle(p, n, radius), *sphere(p, radius), *point_pair(p - n * radius, p + n * radius),
			*imaginary_circle(p, n, radius), *imaginary_sphere(p, radius), *imaginary_point_pair(p, n, radius) };
		const auto check = [&](const auto &round, double sign) {
			REQUIRE(round);
			CHECK(glm::length(typed::center(*round * weight) - p) < 1e-12);
			CHECK(std::abs(typed::squared_radius(*round * weight) - sign * radius * radius) < 1e-11);
		};
		check(typed::Circle<>::from(rounds[0]), 1.0);
		check(typed::Sphere<>::from(rounds[1]), 1.0);
		check(typed::PointPair<>::from(rounds[2]), 1.0);
		check(typed::Circle<>::from(rounds[3]), -1.0);
		check(typed::Sphere<>::from(rounds[4]), -1.0);
		check(typed::PointPair<>::from(rounds[5]), -1.0);
	}
}

TEST_CASE("two spheres meet in the circle that meet() finds, real or imaginary") {
	Random random(74);
	int real = 0, imaginary = 0;
	for (int repeat = 0; repeat < CASES; ++repeat) {
		const Vector3D p = random.vector(1.0), q = random.vector(1.0);
		const double r = random.uniform(0.3, 2.0), s = random.uniform(0.3, 2.0);
		const typed::Circle<> shared = typed::sphere(p, r).regressive_product(typed::sphere(q, s));
		// Elementary geometry: the center's position along the axis, and the remainder of r^2.
		const double squared_distance = glm::dot(q - p, q - p);
		const double along = 0.5 * (1.0 + (r * r - s * s) / squared_distance);
		const double squared_radius = r * r - along * along * squared_distance;
		CHECK(std::abs(typed::squared_radius(shared) - squared_radius) < 1e-9 * (1.0 + 1.0 / squared_distance));
		CHECK(glm::length(typed::center(shared) - (p + along * (q - p))) < 1e-9 * (1.0 + 1.0 / squared_distance));
		++(squared_radius > 0.0 ? real : imaginary);
		const MultivectorResult general = meet(*sphere(p, r), *sphere(q, s));
		REQUIRE(general);
		if (std::abs(squared_radius) > 1e-3) {
			CHECK(angle_between_elements(*general, shared.to_multivector()) < 1e-7);
		}
	}
	CHECK(real > CASES / 10);
	CHECK(imaginary > CASES / 10);
}

TEST_CASE("objects with float coefficients") {
	const auto a = typed::point(Vector3<float>(1, 2, 3)), b = typed::point(Vector3<float>(1, 2, 5));
	CHECK(typed::squared_distance(a, b) == doctest::Approx(4.0f));
	const typed::Line<float> line = a.outer_product(b).outer_product(typed::infinity<float>());
	CHECK(classify(line.to_multivector()).kind == Kind::LINE);
}
