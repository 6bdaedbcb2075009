#include "playground/handles/constraint.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace playground::handles;

namespace {

// From the eye at (0, 0, 10), which looks along -z, through a point.
ViewRay through(const Vector &point, const Vector &eye = { 0.0, 0.0, 10.0 }) {
	return { eye, point - eye, { 0.0, 0.0, -1.0 } };
}

double distance(const ViewRay &ray, const Vector &place) {
	return glm::length(glm::cross(place - ray.origin, glm::normalize(ray.direction)));
}

bool is_near(const Vector &left, const Vector &right, double tolerance = 1e-9) {
	return glm::length(left - right) < tolerance;
}

} // namespace

TEST_CASE("free: in the plane across the view, under the mouse") {
	const Constraint held{ Motion::FREE, { 1.0, 2.0, 3.0 }, {}, {} };
	const std::optional<Vector> place = position_on(through({ 4.0, -1.0, 0.0 }), held);
	REQUIRE(place);
	CHECK(place->z == doctest::Approx(3.0));
	CHECK(distance(through({ 4.0, -1.0, 0.0 }), *place) < 1e-9);
	const std::optional<Vector> on_level = position_on({ { 0.0, 5.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 } }, held);
	REQUIRE(on_level);
	CHECK(is_near(*on_level, { 3.0, 2.0, 0.0 }));
}

TEST_CASE("along a line: the place nearest to the ray") {
	const Constraint held{ Motion::LINE, { 1.0, 0.0, 0.0 }, {}, { 1.0, 0.0, 0.0 } };
	CHECK(is_near(*position_on(through({ 3.5, 0.0, 0.0 }), held), { 3.5, 0.0, 0.0 }));
	const std::optional<Vector> beside = position_on(through({ 3.5, 2.0, 0.0 }), held);
	REQUIRE(beside);
	CHECK(is_near(*beside, { beside->x, 0.0, 0.0 }));
	for (const double step : { -1e-3, 1e-3 }) {
		CHECK(distance(through({ 3.5, 2.0, 0.0 }), *beside) < distance(through({ 3.5, 2.0, 0.0 }), *beside + Vector(step, 0.0, 0.0)));
	}
}

TEST_CASE("on a sphere: under the mouse on the side where it is, else on the outline") {
	const Constraint front{ Motion::SPHERE, { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 }, {} };
	const Constraint back{ Motion::SPHERE, { 0.0, 0.0, -2.0 }, { 0.0, 0.0, 0.0 }, {} };
	const ViewRay ray = through({ 0.7, 0.4, 0.0 });
	for (const Constraint &held : { front, back }) {
		const std::optional<Vector> place = position_on(ray, held);
		REQUIRE(place);
		CHECK(glm::length(*place) == doctest::Approx(2.0));
		CHECK(distance(ray, *place) < 1e-9);
		CHECK(place->z * held.position.z > 0.0);
	}
	const std::optional<Vector> outline = position_on(through({ 5.0, 0.0, 0.0 }), front);
	REQUIRE(outline);
	CHECK(glm::length(*outline) == doctest::Approx(2.0));
	CHECK(distance(through({ 5.0, 0.0, 0.0 }), *outline) == doctest::Approx(glm::length(glm::cross(Vector(0.0, 0.0, 10.0), glm::normalize(Vector(5.0, 0.0, -10.0)))) - 2.0));
	// From inside the only place that is before the eye.
	CHECK(is_near(*position_on({ {}, { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, front), { 2.0, 0.0, 0.0 }));
}

TEST_CASE("on a circle: under the mouse where it can be, else nearest") {
	const Constraint held{ Motion::CIRCLE, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } };
	const Vector on_it(2.0 * std::cos(1.0), 2.0 * std::sin(1.0), 0.0);
	CHECK(is_near(*position_on(through(on_it), held), on_it));
	CHECK(is_near(*position_on({ { 0.0, 3.0, 10.0 }, { 0.0, 0.0, -1.0 }, {} }, held), { 0.0, 2.0, 0.0 }, 1e-6));
	CHECK(is_near(*position_on({ { 0.5, 0.5, 10.0 }, { 0.0, 0.0, -1.0 }, {} }, held), { std::sqrt(2.0), std::sqrt(2.0), 0.0 }, 1e-6));
	// Seen from the side: of the two places behind each other that on its side.
	const Constraint from_side{ Motion::CIRCLE, { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
	CHECK(is_near(*position_on(through({ 0.5, 0.0, std::sqrt(3.75) }), from_side), { 0.5, 0.0, std::sqrt(3.75) }));
}

TEST_CASE("where there is no place") {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const Constraint along_view{ Motion::LINE, { 0.0, 0.0, 0.0 }, {}, { 0.0, 0.0, -1.0 } };
	const Constraint free{ Motion::FREE, { 0.0, 0.0, 0.0 }, {}, {} };
	CHECK_FALSE(position_on({ { 1.0, 0.0, 10.0 }, { 0.0, 0.0, -1.0 }, {} }, along_view));
	CHECK_FALSE(position_on({ { 0.0, 0.0, 10.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 } }, free));
	CHECK_FALSE(position_on({ { 0.0, 0.0, -10.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, -1.0 } }, free));
	CHECK_FALSE(position_on({ { 0.0, 0.0, 10.0 }, { 0.0, 0.0, -1.0 }, {} }, free));
	CHECK_FALSE(position_on({ { 0.0, 0.0, 10.0 }, {}, { 0.0, 0.0, -1.0 } }, free));
	CHECK_FALSE(position_on({ { nan, 0.0, 10.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, -1.0 } }, free));
	CHECK_FALSE(position_on({ { 0.0, 0.0, 10.0 }, { 0.0, nan, -1.0 }, { 0.0, 0.0, -1.0 } }, free));
	CHECK_FALSE(position_on(through({ 1.0, 0.0, 0.0 }), { Motion::SPHERE, {}, {}, {} }));
	CHECK_FALSE(position_on(through({ 1.0, 0.0, 0.0 }), { Motion::CIRCLE, {}, {}, { 0.0, 0.0, 1.0 } }));
	CHECK_FALSE(position_on(through({ 5.0, 0.0, 20.0 }), { Motion::SPHERE, { 1.0, 0.0, 0.0 }, {}, {} }));
	CHECK_FALSE(position_on({ { 0.0, 0.0, 10.0 }, { 1.0, 0.0, -1e-300 }, { 0.0, 0.0, -1.0 } }, free));
	CHECK_FALSE(position_on({ { 1e300, 0.0, 1e300 }, { 0.0, 0.0, -1e300 }, { 0.0, 0.0, -1.0 } }, free));
}

TEST_CASE("whatever the ray and the constraint, a place is finite and keeps to it") {
	std::mt19937 random(7);
	std::uniform_real_distribution<double> number(-5.0, 5.0);
	const auto vector = [&] { return Vector(number(random), number(random), number(random)); };
	int found = 0;
	for (int i = 0; i < 4000; ++i) {
		Constraint held{ Motion(i % 4), vector(), vector(), glm::normalize(vector()) };
		if (held.motion == Motion::CIRCLE) {
			held.position -= held.axis * glm::dot(held.position - held.center, held.axis);
		}
		const double size = i % 3 == 0 ? std::pow(10.0, number(random) * 4.0) : 1.0;
		const ViewRay ray{ vector() * size, vector(), vector() };
		const std::optional<Vector> place = position_on(ray, held);
		if (!place) {
			continue;
		}
		++found;
		REQUIRE(glm::length(*place) <= MAX_DISTANCE);
		const double tolerance = 1e-9 * (1.0 + size + glm::length(*place));
		CHECK(glm::dot(*place - ray.origin, ray.direction) > -tolerance);
		switch (held.motion) {
			case Motion::FREE:
				CHECK(distance(ray, *place) < tolerance);
				break;
			case Motion::LINE:
				CHECK(glm::length(glm::cross(*place - held.position, held.axis)) < tolerance);
				break;
			case Motion::CIRCLE:
				CHECK(std::abs(glm::dot(*place - held.center, held.axis)) < tolerance);
				[[fallthrough]];
			case Motion::SPHERE:
				CHECK(std::abs(glm::length(*place - held.center) - glm::length(held.position - held.center)) < tolerance);
				break;
		}
	}
	CHECK(found > 2000);
}
