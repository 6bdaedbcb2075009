#include "playground/drawing/figure.hpp"

#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/object/construct.hpp"
#include "playground/drawing/motor_strokes.hpp"
#include "shader_functions.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>

using namespace playground::drawing;
using cga::Multivector;

namespace {

const Vector CENTERS[] = { { 0.0, 0.0, 0.0 }, { 1.0, -2.0, 0.5 }, { 3000.0, -40.0, 900.0 } };
const Vector NORMALS[] = { { 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 }, { -1.0, 2.0, 3.0 } };
constexpr double RADII[] = { 1e-3, 1.0, 50.0, 1e3, 1e5 };

void check_rigid(const Placement &at) {
	CHECK(glm::dot(glm::cross(at.x, at.y), at.z) == doctest::Approx(1.0));
	CHECK(std::abs(glm::dot(at.x, at.y)) + std::abs(glm::dot(at.y, at.z)) + std::abs(glm::dot(at.z, at.x)) < 1e-12);
}

Vector on_ring(const Part &part, float angle, float ring = 0.0f) {
	return part.placement.apply(Vector(shader_functions::ring_point(float(std::abs(part.radius)), angle, ring)));
}

} // namespace

TEST_CASE("a drawn circle has the center, radius and orientation of the circle") {
	for (const Vector &center : CENTERS) {
		for (const Vector &axis : NORMALS) {
			for (const double radius : RADII) {
				if (radius < 1e-6 * glm::length(center)) {
					continue; // beyond the precision of the coefficients
				}
				const Vector normal = glm::normalize(axis);
				const Figure figure = figure_of(*cga::circle(center, axis, radius));
				REQUIRE(figure.parts.size() == 1);
				const Part &part = figure.parts[0];
				CHECK(part.form == Form::CIRCLE);
				CHECK_FALSE(figure.imaginary);
				check_rigid(part.placement);
				// The second term is the rounding error of the radius far from the origin.
				const double tolerance = 1e-5 * radius + 1e-10 * glm::dot(center, center);
				for (float angle = -3.0f; angle < 3.1f; angle += 0.5f) {
					const Vector point = on_ring(part, angle);
					CHECK(std::abs(glm::length(point - center) - radius) < tolerance);
					CHECK(std::abs(glm::dot(point - center, normal)) < tolerance);
					const Vector ahead = on_ring(part, angle + 0.3f);
					CHECK(glm::dot(glm::cross(point - center, ahead - center), normal) > 0.0);
				}
			}
		}
	}
}

TEST_CASE("points of a drawn circle satisfy its equation") {
	const Multivector circle = *cga::circle_through({ 1.0, 0.0, 0.2 }, { 0.0, 2.0, -0.3 }, { -1.0, 0.4, 1.0 });
	const Figure figure = figure_of(circle);
	for (float angle = -3.0f; angle < 3.1f; angle += 0.25f) {
		const Multivector point = cga::point(on_ring(figure.parts[0], angle));
		CHECK(point.outer_product(circle).max_abs() < 1e-5 * point.max_abs() * circle.max_abs());
	}
}

TEST_CASE("a huge circle is precise near the origin") {
	// Almost a line along y at x = -7.
	const Figure figure = figure_of(*cga::circle({ 1e5 - 7.0, 0.0, 3.0 }, { 0.0, 0.0, 1.0 }, 1e5));
	for (const float along : { -20.0f, 0.0f, 5.0f }) {
		const Vector point = on_ring(figure.parts[0], along / 1e5f);
		CHECK(point.x == doctest::Approx(-7.0 + along * along / 2e5).epsilon(1e-5));
		CHECK(std::abs(std::abs(point.y) - std::abs(along)) < 1e-4);
	}
}

TEST_CASE("a drawn sphere has the center and radius of the sphere; its sign is the orientation") {
	for (const Vector &center : CENTERS) {
		for (const double radius : RADII) {
			if (radius < 1e-6 * glm::length(center)) {
				continue;
			}
			const Multivector sphere = *cga::sphere(center, radius);
			const Figure figure = figure_of(sphere);
			REQUIRE(figure.parts.size() == 1);
			CHECK(figure.parts[0].form == Form::SPHERE);
			CHECK(figure.parts[0].radius == doctest::Approx(radius).epsilon(1e-4));
			check_rigid(figure.parts[0].placement);
			for (float ring = 0.0f; ring < 3.0f; ring += 1.0f) {
				CHECK(std::abs(glm::length(on_ring(figure.parts[0], 0.7f, ring) - center) - radius) < 1e-5 * radius + 1e-8 * glm::length(center));
			}
			CHECK(figure_of(-sphere).parts[0].radius < 0.0);
			CHECK(figure_of(sphere.dual(), true).parts[0].radius > 0.0);
			CHECK(figure_of(sphere.dual(), true).dual);
		}
	}
}

TEST_CASE("drawn lines and planes have the position and orientation of the object") {
	for (const Vector &position : CENTERS) {
		for (const Vector &axis : NORMALS) {
			const Vector direction = glm::normalize(axis);
			const Figure line = figure_of(*cga::line(position, axis));
			REQUIRE(line.parts.size() == 1);
			CHECK(line.parts[0].form == Form::LINE);
			CHECK(glm::length(line.parts[0].placement.x - direction) < 1e-9);
			CHECK(glm::length(glm::cross(line.parts[0].placement.origin - position, direction)) < 1e-9 * (1.0 + glm::length(position)));
			const Figure plane = figure_of(*cga::plane(axis, 2.5));
			REQUIRE(plane.parts.size() == 2);
			CHECK(plane.parts[0].form == Form::PLANE);
			check_rigid(plane.parts[0].placement);
			CHECK(glm::length(plane.parts[0].placement.z - direction) < 1e-12);
			CHECK(glm::dot(plane.parts[0].placement.origin, direction) == doctest::Approx(2.5));
			CHECK(plane.parts[1].form == Form::NORMAL);
			CHECK(figure_of(-*cga::plane(axis, 2.5)).parts[0].placement.z == -plane.parts[0].placement.z);
		}
	}
}

TEST_CASE("a drawn point pair is directed from its first point to its second") {
	const Vector a(1.0, 2.0, 3.0), b(-2.0, 0.0, 1.0);
	const Figure figure = figure_of(*cga::point_pair(a, b));
	REQUIRE(figure.parts.size() == 1);
	CHECK(glm::length(figure.parts[0].placement.apply({ -1.0, 0.0, 0.0 }) - a) < 1e-12);
	CHECK(glm::length(figure.parts[0].placement.apply({ 1.0, 0.0, 0.0 }) - b) < 1e-12);
	CHECK(glm::length(*figure.label_position - b) < 1e-12);
}

TEST_CASE("imaginary objects are drawn with the absolute value of their radius") {
	CHECK(figure_of(*cga::imaginary_circle({ 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.7)).imaginary);
	CHECK(figure_of(*cga::imaginary_sphere({ 1.0, 0.0, 0.0 }, 0.7)).imaginary);
	CHECK(figure_of(*cga::imaginary_circle({ 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.7)).parts[0].radius == doctest::Approx(0.7));
	const Figure pair = figure_of(*cga::imaginary_point_pair({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.7));
	CHECK(glm::length(pair.parts[0].placement.x) == doctest::Approx(0.7));
	CHECK(pair.imaginary);
}

TEST_CASE("the forms of the other kinds of objects") {
	const Vector position(1.0, 2.0, 3.0), axis(0.0, 0.6, 0.8);
	const auto only_form = [](const Multivector &x, bool ipns = false) {
		const Figure figure = figure_of(x, ipns);
		REQUIRE(figure.parts.size() == 1);
		return figure.parts[0].form;
	};
	CHECK(only_form(cga::point(position)) == Form::POINT);
	CHECK(only_form(cga::point(position).dual(), true) == Form::POINT);
	CHECK(only_form(*cga::flat_point(position)) == Form::FLAT_POINT);
	CHECK(only_form(*cga::tangent_along(position, axis)) == Form::TANGENT_ALONG);
	CHECK(only_form(*cga::tangent_across(position, axis)) == Form::TANGENT_ACROSS);
	CHECK(only_form(*cga::direction(axis)) == Form::DIRECTION_ALONG);
	CHECK(only_form(*cga::direction_across(axis)) == Form::DIRECTION_ACROSS);
	CHECK(glm::length(figure_of(*cga::direction(axis)).parts[0].placement.z - axis) < 1e-12);
	for (const Multivector &nothing : { Multivector::scalar(2.0), Multivector(), *Multivector::basis("einf"), Multivector::basis_blade(1) + Multivector::basis_blade(7) + Multivector::basis_blade(16) }) {
		CHECK(figure_of(nothing).parts.empty());
		CHECK_FALSE(figure_of(nothing).label_position.has_value());
	}
}

TEST_CASE("the axis of a motor is invariant, and its path ends at the image of the origin") {
	const cga::Quaternion<double> rotation = glm::angleAxis(2.0, glm::normalize(Vector(1.0, 2.0, -1.0)));
	for (const double scale : { 1.0, 0.5, 2.0 }) {
		const cga::Pose<double> pose{ { 1.0, -0.5, 2.0 }, rotation, scale };
		const MotorAxis axis = *axis_of(pose);
		for (const double along : { -1.0, 0.0, 2.0 }) {
			const Vector point = axis.point + along * axis.direction;
			const Vector moved = pose.translation + scale * (rotation * point);
			CHECK(glm::length(glm::cross(moved - axis.point, axis.direction)) < 1e-9);
		}
		const Figure figure = figure_of(cga::to_multivector(cga::Motor<double>::from_pose(pose)));
		REQUIRE(figure.parts.size() == 2);
		CHECK(figure.parts[0].form == Form::LINE);
		CHECK(figure.parts[0].dashed);
		CHECK(figure.parts[1].form == Form::CUSTOM);
		const StrokeVertex &end = figure.custom.vertices[2 * size_t(PATH_STEPS)];
		CHECK(glm::length(Vector(end.position) - pose.translation) < 1e-5);
	}
	CHECK_FALSE(axis_of({ { 1.0, 2.0, 3.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 }).has_value());
	CHECK(figure_of(cga::translator({ 1.0, 2.0, 3.0 })).parts.size() == 1);
}

TEST_CASE("bounds contain the drawn points") {
	const Figure figure = figure_of(*cga::circle({ 1.0, 2.0, 3.0 }, { 0.0, 1.0, 1.0 }, 5.0));
	const Box box = bounds_of(figure.parts[0], figure.custom);
	for (float angle = -3.0f; angle < 3.1f; angle += 0.1f) {
		const Vector point(shader_functions::ring_point(5.0f, angle, 0.0f));
		CHECK(glm::all(glm::lessThanEqual(box.min - 1e-5, point)));
		CHECK(glm::all(glm::lessThanEqual(point, box.max + 1e-5)));
	}
}

TEST_CASE("placements are composed") {
	const Placement space{ { 0.0, 2.0, 0.0 }, { -2.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 }, { 10.0, 0.0, 1.0 } };
	const Placement inner{ { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.0, -1.0, 0.0 }, { 3.0, 4.0, 5.0 } };
	const Vector point(0.3, -0.7, 1.1);
	const Vector apart = placed(inner, space).apply(point) - space.apply(inner.apply(point));
	CHECK(glm::length(apart) < 1e-12);
}

TEST_CASE("the merged box contains both boxes") {
	const Box a{ { -1.0, 0.0, 2.0 }, { 0.0, 1.0, 3.0 } }, b{ { -0.5, -4.0, 2.5 }, { 6.0, 0.5, 2.6 } };
	const Box both = merged(a, b);
	CHECK(contains(both, a));
	CHECK(contains(both, b));
	CHECK(contains(a, a));
	CHECK_FALSE(contains(a, b));
	CHECK(both.min == Vector(-1.0, -4.0, 2.0));
	CHECK(both.max == Vector(6.0, 1.0, 3.0));
}

TEST_CASE("the bounds of a sphere and of a circle of any radius are finite") {
	for (const double radius : { 1.0, 1e30, 1e155, 1e300, 1.7e308 }) {
		for (const Form form : { Form::CIRCLE, Form::SPHERE }) {
			Part part;
			part.form = form;
			part.radius = -radius;
			const Box box = bounds_of(part, Strokes());
			const glm::vec3 size(box.max - box.min);
			CHECK(std::isfinite(size.x + size.y + size.z));
			CHECK(size.x > 0.0f);
		}
	}
}

TEST_CASE("a motor beyond the range of single precision is not drawn") {
	for (const double far : { 1e3, 1e39, 1e68 }) {
		// Half a turn about an axis at that distance.
		cga::Multivector motor;
		for (const char *blade : { "e13", "e21", "e32" }) {
			motor += *cga::Multivector::basis(blade) * std::sqrt(1.0 / 3.0);
		}
		for (const char *blade : { "e24", "e25", "e43", "e53", "e1234", "e1235" }) {
			motor += *cga::Multivector::basis(blade) * far;
		}
		const Figure figure = figure_of(motor);
		CHECK(figure.parts.empty() == (far > 1e38));
		CHECK(figure.custom.vertices.empty() == (far > 1e38));
		CHECK(figure.label_position.has_value() == (far < 1e38));
	}
}
