#include "cga/object/classify.hpp"

#include "../random_poses.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/object/construct.hpp"

#include <doctest/doctest.h>

using namespace cga;
using namespace cga_test;

namespace {

constexpr int CASES = 1000;

Multivector blade(const char *name) {
	return *Multivector::basis(name);
}

double gap(const std::optional<Vector3D> &found, const Vector3D &wanted) {
	REQUIRE(found);
	return glm::length(*found - wanted);
}

double angle(const std::optional<Vector3D> &found, const Vector3D &wanted) {
	REQUIRE(found);
	return glm::length(glm::cross(*found, wanted));
}

} // namespace

TEST_CASE("the classification recovers the parameters of a constructor, for any weight and sign") {
	Random random(1);
	for (int i = 0; i < CASES; ++i) {
		const Vector3D p = random.vector(1.0), n = glm::normalize(random.vector(1.0));
		const double radius = random.uniform(0.1, 3.0), weight = random.scale() * (i % 2 == 0 ? 1.0 : -1.0);
		const Classification of_circle = classify(*circle(p, n, radius) * weight);
		CHECK(of_circle.kind == Kind::CIRCLE);
		CHECK(gap(of_circle.center, p) < 1e-13);
		CHECK(angle(of_circle.normal, n) < 1e-13);
		CHECK(std::abs(*of_circle.radius - radius) < 1e-12);
		const Classification of_sphere = classify(sphere(p, radius)->dual() * weight, true);
		CHECK(of_sphere.kind == Kind::SPHERE);
		CHECK(of_sphere.ipns);
		CHECK(gap(of_sphere.center, p) < 1e-12);
		CHECK(std::abs(*of_sphere.radius - radius) < 1e-11);
		const Classification of_plane = classify(*plane(n, radius) * weight);
		CHECK(of_plane.kind == Kind::PLANE);
		CHECK(*of_plane.distance * glm::dot(*of_plane.normal, n) == doctest::Approx(radius).epsilon(1e-14));
		const Classification of_line = classify(*line(p, n) * weight);
		CHECK(of_line.kind == Kind::LINE);
		CHECK(angle(of_line.direction, n) < 1e-14);
		CHECK(gap(of_line.center, p - n * glm::dot(n, p)) < 1e-13);
		const Classification of_pair = classify(*point_pair(p, p + n * radius) * std::abs(weight));
		CHECK(of_pair.kind == Kind::POINT_PAIR);
		REQUIRE(of_pair.points);
		CHECK(glm::length((*of_pair.points)[0] - p) < 1e-12);
		CHECK(glm::length((*of_pair.points)[1] - p - n * radius) < 1e-12);
	}
}

TEST_CASE("the parameters of every constructor are recovered, from a millimeter to 100 km") {
	Random random(2);
	for (int i = 0; i < 3 * CASES; ++i) {
		const double size = std::pow(10.0, random.uniform(-3.0, 5.0));
		const Vector3D p = random.vector(size), n = glm::normalize(random.vector(1.0));
		const double radius = random.uniform(0.5, 3.0) * size;
		// Coefficients of e4 and e5 hold p^2 beside 1.
		const double squares = 1.0 + (glm::dot(p, p) + radius * radius) / (size * size);
		const double rounding = 2e-15 * squares * (size * size + 1.0 / (size * size) + 1.0);
		CAPTURE(size);
		const auto check_round = [&](const MultivectorResult &made, Kind kind, bool imaginary, bool ipns) {
			const Classification found = classify((ipns ? made->dual() : *made) * -random.scale(), ipns);
			CHECK(found.kind == kind);
			CHECK(found.ipns == ipns);
			CHECK(found.imaginary == imaginary);
			CHECK(gap(found.center, p) < rounding * size);
			REQUIRE(found.radius);
			CHECK(std::abs(*found.radius - radius) < rounding * size);
			if (kind == Kind::CIRCLE || kind == Kind::POINT_PAIR) {
				CHECK(angle(kind == Kind::CIRCLE ? found.normal : found.direction, n) < rounding);
			}
		};
		for (const bool ipns : { false, true }) {
			check_round(circle(p, n, radius), Kind::CIRCLE, false, ipns);
			check_round(sphere(p, radius), Kind::SPHERE, false, ipns);
			check_round(point_pair(p - n * radius, p + n * radius), Kind::POINT_PAIR, false, ipns);
			check_round(imaginary_circle(p, n, radius), Kind::CIRCLE, true, ipns);
			check_round(imaginary_sphere(p, radius), Kind::SPHERE, true, ipns);
			check_round(imaginary_point_pair(p, n, radius), Kind::POINT_PAIR, true, ipns);
		}
		const Vector3D foot = p - n * glm::dot(n, p);
		const double flat_rounding = 1e-14 * squares;
		CHECK(gap(classify(*flat_point(p)).center, p) < flat_rounding * size);
		CHECK(gap(classify(*line(p, n)).center, foot) < flat_rounding * size);
		CHECK(angle(classify(line(p, n)->dual(), true).direction, n) < flat_rounding);
		CHECK(std::abs(*classify(*plane(n, radius)).distance - radius) < flat_rounding * size);
		CHECK(glm::length(*classify(*plane(n, radius)).normal - n) < flat_rounding);
		CHECK(angle(classify(*direction(n)).direction, n) < 1e-15);
		CHECK(angle(classify(*direction_across(n)).normal, n) < 1e-15);
		CHECK(gap(classify(point(p)).center, p) < rounding * size);
		CHECK(classify(point(p)).kind == Kind::POINT);
		CHECK(gap(classify(*tangent_along(p, n)).center, p) < rounding * size);
		CHECK(classify(*tangent_along(p, n)).kind == Kind::TANGENT);
		CHECK(classify(*tangent_across(p, n)).kind == Kind::TANGENT);
	}
}

TEST_CASE("every kind, at scales from a millimeter to 100 km") {
	for (const double size : { 1e-3, 1.0, 1e3, 1e5 }) {
		const Vector3D p = Vector3D(1, -2, 0.5) * size, n = glm::normalize(Vector3D(2, 1, -1));
		CHECK(classify(point(p)).kind == Kind::POINT);
		CHECK(classify(point(p).dual(), true).kind == Kind::POINT);
		CHECK(classify(*flat_point(p)).kind == Kind::FLAT_POINT);
		CHECK(classify(*direction(n)).kind == Kind::DIRECTION);
		CHECK(classify(*direction_across(n)).kind == Kind::DIRECTION);
		CHECK(angle(classify(*direction_across(n)).normal, n) < 1e-15);
		CHECK(classify(e_infinity()).kind == Kind::DIRECTION);
		const Classification along = classify(*tangent_along(p, n)), across = classify(*tangent_across(p, n));
		CHECK(along.kind == Kind::TANGENT);
		CHECK(angle(along.direction, n) < 1e-5);
		CHECK(across.kind == Kind::TANGENT);
		CHECK(angle(across.normal, n) < 1e-5);
		const Classification imaginary = classify(*imaginary_sphere(p, size));
		CHECK(imaginary.kind == Kind::SPHERE);
		CHECK(imaginary.imaginary);
		CHECK(*imaginary.radius == doctest::Approx(size).epsilon(1e-5));
		CHECK(classify(*imaginary_circle(p, n, size)).imaginary);
		const Classification imaginary_pair = classify(*imaginary_point_pair(p, n, size));
		CHECK(imaginary_pair.kind == Kind::POINT_PAIR);
		CHECK(imaginary_pair.imaginary);
		CHECK_FALSE(imaginary_pair.points);
	}
}

TEST_CASE("an element that is an object only in the other representation is reported as dual") {
	const Multivector dual_plane = blade("e3") + 2.0 * e_infinity();
	const Classification found = classify(dual_plane);
	CHECK(found.kind == Kind::PLANE);
	CHECK(found.ipns);
	CHECK(std::abs(*found.distance) == doctest::Approx(2.0));
	CHECK(classify(dual_plane, true).ipns);
	CHECK(classify(blade("e12")).kind == Kind::LINE);
	CHECK(classify(blade("e12")).ipns);
	const Classification sphere_read_as_dual = classify(*sphere({ 1, 0, 0 }, 2.0), true);
	CHECK(sphere_read_as_dual.kind == Kind::SPHERE);
	CHECK_FALSE(sphere_read_as_dual.ipns);
}

TEST_CASE("versors are classified by the motion") {
	const QuaternionD turn(0.8, 0.0, 0.6, 0.0);
	CHECK(classify(rotor(turn)).kind == Kind::ROTOR);
	CHECK(classify(translator({ 1e-6, 0, 0 })).kind == Kind::TRANSLATOR);
	CHECK(classify(dilator(2.0)).kind == Kind::DILATOR);
	CHECK(classify(translator({ 1, 0, 0 }).geometric_product(rotor(turn)) * -3.0).kind == Kind::MOTOR);
	CHECK(classify(Multivector::scalar(-2.0)).kind == Kind::SCALAR);
}

TEST_CASE("other elements have the kind NONE and the deviation from a blade") {
	CHECK(classify(Multivector()).kind == Kind::NONE);
	CHECK(classify(Multivector() * std::numeric_limits<double>::infinity()).kind == Kind::NONE);
	const Classification not_a_blade = classify(blade("e12") + 0.02 * blade("e34"));
	CHECK(not_a_blade.kind == Kind::NONE);
	CHECK(not_a_blade.residual == doctest::Approx(0.04));
	CHECK(classify(blade("e1") + blade("e12")).kind == Kind::NONE);
	CHECK(describe(not_a_blade) == "not a blade (residual 0.04)");
}

TEST_CASE("describe() gives one line") {
	CHECK(describe(classify(*circle({ 0, 1, 0 }, { 0, 0, 1 }, 1.5))) == "circle, radius 1.5, center (0, 1, 0), normal (0, 0, 1)");
	CHECK(describe(classify(point({ 1, 2, 3 }))) == "point, at (1, 2, 3)");
	CHECK(describe(classify(*plane({ 0, 0, 2 }, -1.0))) == "plane, distance -1, normal (0, 0, 1)");
	CHECK(describe(classify(*imaginary_sphere({ 0, 0, 0 }, 2.0))) == "imaginary sphere, radius 2, center (0, 0, 0)");
	CHECK(describe(classify(-blade("e3"))) == "dual plane, distance 0, normal (0, 0, 1)");
}
