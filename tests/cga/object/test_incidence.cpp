#include "cga/object/incidence.hpp"

#include "../versor/random_versors.hpp"
#include "cga/object/classify.hpp"
#include "cga/object/construct.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace cga;
using namespace cga_test;

namespace {

constexpr int CASES = 2000;

// A random blade of grade 1 to 4, including points and e_inf.
Multivector random_blade(Random &random) {
	Multivector blade = point(random.vector(1.0));
	const int factors = int(random.uniform(0.0, 4.0));
	for (int i = 0; i < factors; ++i) {
		blade = blade.outer_product(i == 0 && random.uniform(0.0, 1.0) < 0.3 ? e_infinity() : point(random.vector(1.0)));
	}
	return blade;
}

Kind kind_of(const MultivectorResult &x) {
	REQUIRE_MESSAGE(x, describe(x.error()));
	return classify(*x).kind;
}

double relative(const Multivector &x, const Multivector &size) {
	return x.max_abs() / size.max_abs();
}

// The part of X B above grade |b - x|, which is zero if X is in B.
Multivector contained(const Multivector &x, const Multivector &b) {
	return x.geometric_product(b) - x.left_contraction(b);
}

} // namespace

TEST_CASE("every vector of the meet is in both, and every one of both in the join") {
	Random random(1);
	for (int i = 0; i < CASES; ++i) {
		const Multivector a = random_blade(random), b = random_blade(random);
		const MultivectorResult shared = meet(a, b), spanned = join(a, b);
		REQUIRE(shared);
		REQUIRE(spanned);
		// A is in the join J, and the meet M is in A: with the larger of two blades, their inner product is a product.
		CHECK(relative(contained(a, *spanned), *spanned) < 1e-7 * a.max_abs());
		CHECK(relative(contained(b, *spanned), *spanned) < 1e-7 * b.max_abs());
		CHECK(relative(contained(*shared, a), a) < 1e-7 * shared->max_abs());
		CHECK(relative(contained(*shared, b), b) < 1e-7 * shared->max_abs());
		if (kind_of(shared) == Kind::POINT) {
			CHECK(relative(shared->outer_product(a), *shared) < 1e-7 * a.max_abs());
			CHECK(relative(shared->outer_product(b), *shared) < 1e-7 * b.max_abs());
		}
		const Classification pair = classify(*shared);
		if (pair.points) {
			for (const Vector3D &end : *pair.points) {
				const double size = 1.0 + glm::dot(end, end);
				CHECK(relative(point(end).outer_product(a), a) < 1e-7 * size);
				CHECK(relative(point(end).outer_product(b), b) < 1e-7 * size);
			}
		}
	}
}

TEST_CASE("versors preserve incidence: a point lies on an object if and only if its image lies on the image of the object") {
	Random random(3);
	for (int i = 0; i < CASES; ++i) {
		const Vector3D center = random.vector(1.0), normal = glm::normalize(random.vector(1.0));
		const Vector3D across = glm::normalize(glm::cross(normal, random.vector(1.0)));
		const double radius = random.uniform(0.3, 2.0);
		const struct {
			Multivector object;
			Vector3D on;
			Vector3D off;
		} scenes[] = {
			{ *point_pair(center - normal, center + normal), center + normal, center },
			{ *circle(center, normal, radius), center + across * radius, center },
			{ *sphere(center, radius), center - normal * radius, center },
			{ *flat_point(center), center, center + across },
			{ *line(center, normal), center + normal * 3.0, center + across },
			{ *plane(normal, glm::dot(normal, center)), center + across * 3.0, center + normal },
		};
		// Reflections, inversions and their products, including rotations, motions and dilations.
		const Multivector versor = random_product(random, 1 + i % 4);
		const auto image = [&](const Multivector &x) { return *versor.sandwich(x); };
		for (const auto &[object, on, off] : scenes) {
			const double size = image(object).max_abs();
			CHECK(image(point(on)).outer_product(image(object)).max_abs() < 1e-9 * size * image(point(on)).max_abs());
			// The image of an outer product is the outer product of the images.
			const Multivector outside = image(point(off)).outer_product(image(object));
			CHECK(relative(outside - image(point(off).outer_product(object)), outside) < 1e-9 * size);
			CHECK(outside.max_abs() > 1e-9 * size * image(point(off)).max_abs());
		}
	}
}

TEST_CASE("meet and join of degenerate pairs") {
	const Multivector ground = *plane({ 0, 0, 1 }, 0.0), unit_sphere = *sphere({ 0, 0, 0 }, 1.0), x_axis = *line({ 0, 0, 0 }, { 1, 0, 0 });
	CHECK(kind_of(meet(x_axis, *line({ 0, 0, 0 }, { 0, 1, 0 }))) == Kind::FLAT_POINT);
	CHECK(kind_of(join(x_axis, *line({ 0, 0, 0 }, { 0, 1, 0 }))) == Kind::PLANE);
	CHECK(kind_of(meet(x_axis, *line({ 0, 2, 0 }, { 1, 0, 0 }))) == Kind::DIRECTION);
	CHECK(kind_of(join(x_axis, *line({ 0, 2, 0 }, { 1, 0, 0 }))) == Kind::PLANE);
	CHECK(kind_of(meet(x_axis, *line({ 0, 2, 0 }, { 0, 0, 1 }))) == Kind::DIRECTION);
	CHECK(kind_of(meet(x_axis, x_axis)) == Kind::LINE);
	CHECK(kind_of(meet(x_axis, ground)) == Kind::LINE);
	CHECK(kind_of(join(x_axis, ground)) == Kind::PLANE);
	CHECK(kind_of(meet(*plane({ 0, 0, 1 }, 1.0), ground)) == Kind::DIRECTION);
	CHECK(kind_of(meet(unit_sphere, *plane({ 0, 0, 1 }, 1.0))) == Kind::TANGENT);
	CHECK(kind_of(meet(unit_sphere, *line({ 0, 0, 1 }, { 1, 0, 0 }))) == Kind::TANGENT);
	CHECK(kind_of(meet(unit_sphere, *sphere({ 3, 0, 0 }, 2.0))) == Kind::TANGENT);
	CHECK(kind_of(meet(unit_sphere, unit_sphere)) == Kind::SPHERE);
	CHECK(kind_of(meet(unit_sphere, point({ 0, 1, 0 }))) == Kind::POINT);
	CHECK(kind_of(meet(unit_sphere, point({ 0, 2, 0 }))) == Kind::SCALAR);
	CHECK(classify(*meet(unit_sphere, *sphere({ 5, 0, 0 }, 2.0))).imaginary);
	const Classification concentric = classify(*meet(unit_sphere, *sphere({ 0, 0, 0 }, 2.0)));
	CHECK(concentric.kind == Kind::FLAT_POINT);
	CHECK(concentric.ipns);
	const Multivector rim = *circle({ 0, 0, 0 }, { 0, 0, 1 }, 1.0);
	CHECK(kind_of(meet(rim, *circle({ 1, 0, 0 }, { 0, 0, 1 }, 1.0))) == Kind::POINT_PAIR);
	CHECK(classify(*meet(rim, *circle({ 5, 0, 0 }, { 0, 0, 1 }, 1.0))).imaginary);
	CHECK(kind_of(meet(rim, ground)) == Kind::CIRCLE);
	CHECK(kind_of(meet(rim, unit_sphere)) == Kind::CIRCLE);
}

TEST_CASE("the meet of a small object with a large one keeps its precision") {
	const Multivector unit_circle = *circle({ 0, 0, 0 }, { 0, 0, 1 }, 1.0), unit_sphere = *sphere({ 0, 0, 0 }, 1.0);
	for (double radius = 8.0; radius < 1e8; radius *= 8.0) {
		// Through the origin: x^2 + y^2 + z^2 = 2 radius x, which with x^2 + y^2 + z^2 = 1 makes x = 1 / (2 radius).
		const Multivector large = *sphere({ radius, 0, 0 }, radius);
		const double x = 0.5 / radius;
		for (const Multivector &small : { unit_circle, unit_sphere }) {
			const Classification found = classify(*meet(large, small));
			CHECK(found.kind == (small == unit_circle ? Kind::POINT_PAIR : Kind::CIRCLE));
			CHECK(!found.imaginary);
			CHECK(glm::length(*found.center - Vector3D(x, 0, 0)) < 1e-15);
			CHECK(*found.radius == doctest::Approx(std::sqrt(1.0 - x * x)).epsilon(1e-15));
		}
		const std::optional<Vector3D> image = position_of(*reflect_in(point({ -1, 0, 0 }), large));
		REQUIRE(image);
		CHECK(glm::length(*image - Vector3D(radius / (radius + 1.0), 0, 0)) < 1e-14);
		const Classification mirrored = classify(*reflect_in(large, unit_sphere));
		CHECK(mirrored.kind == Kind::PLANE);
		CHECK(std::abs(*mirrored.distance) == doctest::Approx(x).epsilon(1e-13));
		// A small circle of the large sphere, and one that is askew by more than rounding.
		const Multivector on_large = *circle({ x, 0, 0 }, { 1, 0, 0 }, std::sqrt(1.0 - x * x));
		CHECK(kind_of(meet(large, on_large)) == Kind::CIRCLE);
		CHECK(kind_of(join(large, on_large)) == Kind::SPHERE);
		CHECK(kind_of(meet(large, *circle({ x, 0, 0 }, { 1, 1e-6, 0 }, 1.0))) == Kind::POINT_PAIR);
	}
}

TEST_CASE("rounds are tangent within 1e-10 of the smaller one and rounding of the larger") {
	for (double radius = 1.0; radius < 1e6; radius *= 10.0) {
		const Multivector large = *sphere({ radius, 0, 0 }, radius);
		const auto beside = [&](double gap) { return meet(large, *sphere({ -1.0 - gap, 0, 0 }, 1.0)); };
		CHECK(kind_of(beside(0.0)) == Kind::TANGENT);
		CHECK(kind_of(beside(1e-11)) == Kind::TANGENT);
		CHECK(kind_of(beside(1e-7)) == Kind::CIRCLE);
		CHECK(classify(*beside(1e-7)).imaginary);
		CHECK_FALSE(classify(*beside(-1e-7)).imaginary);
	}
}

TEST_CASE("projection and rejection add up to a vector, and reflecting twice changes nothing") {
	Random random(2);
	for (int i = 0; i < CASES; ++i) {
		const Vector3D p = random.vector(1.0), n = glm::normalize(random.vector(1.0));
		const Multivector mirrors[] = { *plane(n, 0.3), *sphere(random.vector(1.0), random.uniform(0.5, 2.0)), *line(random.vector(1.0), n) };
		for (const Multivector &mirror : mirrors) {
			const MultivectorResult image = reflect_in(point(p), mirror);
			REQUIRE(image);
			const MultivectorResult back = reflect_in(*image, mirror);
			REQUIRE(back);
			const std::optional<Vector3D> position = position_of(*back);
			REQUIRE(position);
			CHECK(glm::length(*position - p) < 1e-8 * (1.0 + glm::dot(p, p)));
		}
		const double distance = glm::dot(n, p) - 0.3;
		const std::optional<Vector3D> mirrored = position_of(*reflect_in(point(p), mirrors[0]));
		REQUIRE(mirrored);
		CHECK(glm::length(*mirrored - (p - 2.0 * distance * n)) < 1e-12);
	}
}

TEST_CASE("elements that are not blades, and null ones that would need an inverse, are rejected with a reason") {
	const Multivector no_blade = Multivector::basis_blade(6) + Multivector::basis_blade(13), good = *sphere({ 0, 0, 0 }, 1.0);
	for (const auto function : { meet, join, project_onto, reject_from, reflect_in }) {
		for (const Multivector &bad : { no_blade, Multivector(), good * std::numeric_limits<double>::infinity(), good + Multivector::scalar(1.0) }) {
			CHECK_FALSE(function(good, bad).has_value());
			CHECK_FALSE(function(bad, good).has_value());
			CHECK_FALSE(std::string(describe(function(bad, good).error())).empty());
		}
	}
	for (const auto function : { project_onto, reject_from, reflect_in }) {
		CHECK_FALSE(function(good, point({ 1, 2, 3 })).has_value());
		CHECK_FALSE(function(good, *direction({ 1, 0, 0 })).has_value());
	}
}
