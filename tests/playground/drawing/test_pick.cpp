#include "playground/drawing/pick.hpp"

#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/object/construct.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace playground::drawing;

namespace {

// The ray from the eye at (0, 0, 10) through a point. The width of a pixel is a thousandth of the depth.
PickRay through(const Vector &point) {
	const Vector eye(0.0, 0.0, 10.0);
	return { eye, glm::normalize(point - eye), 0.0, 1e-3 };
}

double pixels(const cga::Multivector &x, const PickRay &ray) {
	const std::optional<PickHit> found = pick(figure_of(x), ray);
	return found ? found->pixels : INFINITY;
}

} // namespace

TEST_CASE("the distance to a point in pixels") {
	const cga::Multivector point = cga::point({ 1.0, 2.0, 0.0 });
	CHECK(pixels(point, through({ 1.0, 2.0, 0.0 })) == doctest::Approx(0.0));
	CHECK(pixels(point, through({ 1.05, 2.0, 0.0 })) == doctest::Approx(5.0).epsilon(0.05));
	CHECK(pixels(cga::point({ 0.0, 0.0, 20.0 }), through({ 0.0, 0.0, 0.0 })) == INFINITY);
}

TEST_CASE("the distance to a point in an orthogonal view") {
	const PickRay ray{ { 1.05, 2.0, 10.0 }, { 0.0, 0.0, -1.0 }, 0.01, 0.0 };
	CHECK(pixels(cga::point({ 1.0, 2.0, 0.0 }), ray) == doctest::Approx(5.0));
}

TEST_CASE("the distance to a curve is that to its nearest point") {
	CHECK(pixels(*cga::line({ 0.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 }), through({ 3.0, 1.02, 0.0 })) == doctest::Approx(2.0).epsilon(0.1));
	CHECK(pixels(*cga::line({ 0.0, 0.0, 30.0 }, { 1.0, 0.0, 0.0 }), through({ 0.0, 0.0, 0.0 })) == INFINITY);
	for (const double radius : { 1e-3, 1.0, 1e3, 1e5 }) {
		const cga::Multivector circle = *cga::circle({ -radius, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, radius);
		CHECK(pixels(circle, through({ 0.0, 0.0, 0.0 })) < 0.2);
		CHECK(pixels(circle, through({ 0.04, 0.0, 0.0 })) == doctest::Approx(4.0).epsilon(0.05));
	}
	CHECK(pixels(*cga::point_pair({ -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }), through({ 0.5, 0.03, 0.0 })) == doctest::Approx(3.0).epsilon(0.05));
}

TEST_CASE("the distance to a surface is 0 on it, and beside a sphere that to its outline") {
	const Figure sphere = figure_of(*cga::sphere({ 0.0, 0.0, 0.0 }, 2.0));
	const PickHit inside = *pick(sphere, through({ 0.5, 0.0, 0.0 }));
	CHECK(inside.on_surface);
	CHECK(inside.pixels == 0.0);
	CHECK(inside.depth == doctest::Approx(8.03).epsilon(0.01));
	CHECK(pick(sphere, through({ 3.0, 0.0, 0.0 }))->pixels > 50.0);
	const Figure huge = figure_of(*cga::sphere({ 0.0, 0.0, -1e5 }, 1e5));
	CHECK(pick(huge, through({ 0.0, 0.0, 0.0 }))->depth == doctest::Approx(10.0).epsilon(1e-5));
	const Figure plane = figure_of(*cga::plane({ 0.0, 0.0, 1.0 }, -5.0));
	CHECK(pick(plane, through({ 3.0, 2.0, 0.0 }))->on_surface);
	CHECK_FALSE(pick(figure_of(*cga::plane({ 0.0, 0.0, 1.0 }, 50.0)), through({ 3.0, 0.0, 0.0 })).has_value());
}

TEST_CASE("the arrow of a plane takes precedence over its surface") {
	const PickHit at_foot = *pick(figure_of(*cga::plane({ 0.0, 1.0, 0.2 }, 0.0)), through({ 0.0, 0.1, 0.0 }));
	CHECK_FALSE(at_foot.on_surface);
}

TEST_CASE("picking is finite for objects seen edge-on and from inside") {
	for (const cga::Multivector &x : { *cga::plane({ 0.0, 1.0, 0.0 }, 0.0), *cga::circle({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 2.0), *cga::sphere({ 0.0, 0.0, 10.0 }, 3.0), *cga::line({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }) }) {
		const std::optional<PickHit> found = pick(figure_of(x), through({ 0.0, 0.0, 0.0 }));
		CHECK((!found || std::isfinite(found->pixels)));
	}
	CHECK(pick(figure_of(*cga::sphere({ 0.0, 0.0, 10.0 }, 3.0)), through({ 0.0, 0.0, 0.0 }))->depth == doctest::Approx(3.0));
}

TEST_CASE("a motor is picked by its path") {
	const cga::Multivector translator = cga::translator({ 4.0, 0.0, 0.0 });
	CHECK(pixels(translator, through({ 2.2, 0.0, 0.0 })) < 0.5);
	CHECK(pixels(translator, through({ 2.2, 2.0, 0.0 })) > 50.0);
}

TEST_CASE("a form too far away to have a distance in double is not picked") {
	for (const double far : { 1e160, 1e200, 1.7e308 }) {
		for (const Form form : { Form::POINT, Form::POINT_PAIR, Form::CIRCLE, Form::SPHERE, Form::LINE }) {
			for (const double radius : { 1.0, far }) {
				Figure figure;
				figure.parts.push_back({ form, {}, radius });
				figure.parts[0].placement.origin = { 0.5 * far, far, -far };
				const std::optional<PickHit> found = pick(figure, through({ 0.5, 0.0, 0.0 }));
				CHECK((!found || (std::isfinite(found->pixels) && found->pixels >= 0.0 && std::isfinite(found->depth))));
			}
		}
	}
}
