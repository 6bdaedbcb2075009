#include "playground/handles/constraint.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace playground::handles;

namespace {

// The ray from the eye through a point; the view direction is -z.
ViewRay through(const Vector &point, const Vector &eye = { 0.0, 0.0, 10.0 }) {
	return { eye, point - eye, { 0.0, 0.0, -1.0 } };
}

double distance(const ViewRay &ray, const Vector &position) {
	return glm::length(glm::cross(position - ray.origin, glm::normalize(ray.direction)));
}

bool is_near(const Vector &left, const Vector &right, double tolerance = 1e-9) {
	return glm::length(left - right) < tolerance;
}

} // namespace

TEST_CASE("Motion::FREE: under the mouse, in the plane perpendicular to the view") {
	const Constraint constraint{ Motion::FREE, { 1.0, 2.0, 3.0 }, {}, {} };
	const std::optional<Vector> position = position_on(through({ 4.0, -1.0, 0.0 }), constraint);
	REQUIRE(position);
	CHECK(position->z == doctest::Approx(3.0));
	CHECK(distance(through({ 4.0, -1.0, 0.0 }), *position) < 1e-9);
	const std::optional<Vector> on_level = position_on({ { 0.0, 5.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 } }, constraint);
	REQUIRE(on_level);
	CHECK(is_near(*on_level, { 3.0, 2.0, 0.0 }));
}

TEST_CASE("Motion::LINE: the point of the line nearest to the ray") {
	const Constraint constraint{ Motion::LINE, { 1.0, 0.0, 0.0 }, {}, { 1.0, 0.0, 0.0 } };
	CHECK(is_near(*position_on(through({ 3.5, 0.0, 0.0 }), constraint), { 3.5, 0.0, 0.0 }));
	const std::optional<Vector> beside = position_on(through({ 3.5, 2.0, 0.0 }), constraint);
	REQUIRE(beside);
	CHECK(is_near(*beside, { beside->x, 0.0, 0.0 }));
	for (const double step : { -1e-3, 1e-3 }) {
		CHECK(distance(through({ 3.5, 2.0, 0.0 }), *beside) < distance(through({ 3.5, 2.0, 0.0 }), *beside + Vector(step, 0.0, 0.0)));
	}
}

TEST_CASE("Motion::SPHERE: under the mouse on the side of the handle, or on the outline") {
	const Constraint front{ Motion::SPHERE, { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 }, {} };
	const Constraint back{ Motion::SPHERE, { 0.0, 0.0, -2.0 }, { 0.0, 0.0, 0.0 }, {} };
	const ViewRay ray = through({ 0.7, 0.4, 0.0 });
	for (const Constraint &constraint : { front, back }) {
		const std::optional<Vector> position = position_on(ray, constraint);
		REQUIRE(position);
		CHECK(glm::length(*position) == doctest::Approx(2.0));
		CHECK(distance(ray, *position) < 1e-9);
		CHECK(position->z * constraint.position.z > 0.0);
	}
	const std::optional<Vector> outline = position_on(through({ 5.0, 0.0, 0.0 }), front);
	REQUIRE(outline);
	CHECK(glm::length(*outline) == doctest::Approx(2.0));
	CHECK(distance(through({ 5.0, 0.0, 0.0 }), *outline) == doctest::Approx(glm::length(glm::cross(Vector(0.0, 0.0, 10.0), glm::normalize(Vector(5.0, 0.0, -10.0)))) - 2.0));
	// From inside the sphere, only one intersection is in front of the eye.
	CHECK(is_near(*position_on({ {}, { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, front), { 2.0, 0.0, 0.0 }));
}

TEST_CASE("Motion::CIRCLE: under the mouse, or the point of the circle nearest to it") {
	const Constraint constraint{ Motion::CIRCLE, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } };
	const Vector on_circle(2.0 * std::cos(1.0), 2.0 * std::sin(1.0), 0.0);
	CHECK(is_near(*position_on(through(on_circle), constraint), on_circle));
	CHECK(is_near(*position_on({ { 0.0, 3.0, 10.0 }, { 0.0, 0.0, -1.0 }, {} }, constraint), { 0.0, 2.0, 0.0 }, 1e-6));
	CHECK(is_near(*position_on({ { 0.5, 0.5, 10.0 }, { 0.0, 0.0, -1.0 }, {} }, constraint), { std::sqrt(2.0), std::sqrt(2.0), 0.0 }, 1e-6));
	// Seen edge-on, the ray meets the circle twice: the point on the side of the handle.
	const Constraint from_side{ Motion::CIRCLE, { 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
	CHECK(is_near(*position_on(through({ 0.5, 0.0, std::sqrt(3.75) }), from_side), { 0.5, 0.0, std::sqrt(3.75) }));
}

TEST_CASE("no position: parallel rays, positions behind the eye, degenerate or not finite input") {
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

TEST_CASE("for random rays and constraints, a position is finite and satisfies the constraint") {
	std::mt19937 random(7);
	std::uniform_real_distribution<double> number(-5.0, 5.0);
	const auto vector = [&] { return Vector(number(random), number(random), number(random)); };
	int found = 0;
	for (int i = 0; i < 4000; ++i) {
		Constraint constraint{ Motion(i % 4), vector(), vector(), glm::normalize(vector()) };
		if (constraint.motion == Motion::CIRCLE) {
			constraint.position -= constraint.axis * glm::dot(constraint.position - constraint.center, constraint.axis);
		}
		const double size = i % 3 == 0 ? std::pow(10.0, number(random) * 4.0) : 1.0;
		const ViewRay ray{ vector() * size, vector(), vector() };
		const std::optional<Vector> position = position_on(ray, constraint);
		if (!position) {
			continue;
		}
		++found;
		REQUIRE(glm::length(*position) <= MAX_DISTANCE);
		const double tolerance = 1e-9 * (1.0 + size + glm::length(*position));
		CHECK(glm::dot(*position - ray.origin, ray.direction) > -tolerance);
		switch (constraint.motion) {
			case Motion::FREE:
				CHECK(distance(ray, *position) < tolerance);
				break;
			case Motion::LINE:
				CHECK(glm::length(glm::cross(*position - constraint.position, constraint.axis)) < tolerance);
				break;
			case Motion::CIRCLE:
				CHECK(std::abs(glm::dot(*position - constraint.center, constraint.axis)) < tolerance);
				[[fallthrough]];
			case Motion::SPHERE:
				CHECK(std::abs(glm::length(*position - constraint.center) - glm::length(constraint.position - constraint.center)) < tolerance);
				break;
		}
	}
	CHECK(found > 2000);
}
