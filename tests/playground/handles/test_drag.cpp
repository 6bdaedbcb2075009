#include "playground/handles/drag.hpp"

#include "playground/handles/handles.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace playground;
using namespace playground::handles;

namespace {

constexpr double DEGREE = 0.017453292519943295;

ViewRay through(const Vector &point, const Vector &eye = { 3.0, 4.0, 10.0 }) {
	return { eye, point - eye, glm::normalize(-eye) };
}

double distance(const ViewRay &ray, const Vector &position) {
	return glm::length(glm::cross(position - ray.origin, glm::normalize(ray.direction)));
}

std::optional<Handle> find(const Document &document, const char *name, const std::string &key) {
	for (const Handle &handle : handles_of(document, name)) {
		if (handle.key == key) {
			return handle;
		}
	}
	return std::nullopt;
}

// The expression after the drag; unchanged if the handle cannot follow.
std::string dragged(const char *text, const char *key, const ViewRay &ray, const Steps &steps = {}) {
	Document document;
	REQUIRE(document.add("x", text));
	const std::optional<Handle> start = find(document, "x", key);
	REQUIRE_MESSAGE(start, text, " ", key);
	if (const std::optional<Drag> result = drag(document, "x", *start, ray, steps)) {
		const ChangeResult change = document.set_parameter("x", result->parameter, result->value);
		CHECK_MESSAGE(change, change.error().message);
	}
	return document.find("x")->text;
}

} // namespace

TEST_CASE("after a drag the handle is under the mouse") {
	const struct {
		const char *text;
		const char *key;
		Vector target; // on the constraint
	} cases[] = {
		{ "point(1, 2, 3)", "position", { 1.0, 1.0, 1.0 } },
		{ "pair(e1, e2)", "b", { 1.0, -1.0, 1.0 } },
		{ "sphere(e1, 2)", "center", { 0.0, 1.0, 0.0 } },
		{ "sphere(e1, 2)", "radius", { 3.7, 0.0, 0.0 } },
		{ "circle(e1, e2, 2)", "radius", { 1.5, 0.0, 0.0 } },
		{ "circle(e1, e2, 2)", "normal", { 1.0, 0.8, 0.6 } },
		{ "plane(2 e3, 1)", "distance", { 0.0, 0.0, -2.5 } },
		{ "plane(e3, 1)", "normal", { 0.0, 1.2, 1.6 } },
		{ "plane(e3, -1)", "normal", { 0.0, 1.2, -1.6 } },
		{ "line(e1, 3 e2)", "direction", { 1.6, 0.8, 0.0 } },
		{ "translator(1, 2, 3)", "offset", { 1.0, 1.0, 1.0 } },
		{ "rotor(e3, deg(30))", "angle", { 0.0, 0.65, 0.0 } },
		{ "rotor(e3, deg(30))", "axis", { 0.0, 0.6, 0.8 } },
		{ "rotor(0, 0, 0.6, 0.8)", "axis", { 0.0, 0.6, 0.8 } },
		{ "rotor(0, 0, 0.6, 0.8)", "angle", { 0.0, -0.65, 0.0 } },
		{ "motor(e1, 1)", "angle", { 1.65, 0.0, 0.0 } },
		{ "motor(e1, rotor(e3, deg(90)), 2)", "scale", { 0.3, 0.7, 0.7 } },
		{ "motor(e1, rotor(e3, deg(90)), 2)", "translation", { 2.0, 1.0, 0.0 } },
		{ "e2 + 0.5 einf + eo", "object", { 1.0, 1.0, 1.0 } },
		{ "!-[0, 0,1,0,-0.5,0.5, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0, 0]", "object", { 1.0, 1.0, 1.0 } },
	};
	for (const auto &each : cases) {
		const char *text = each.text;
		const char *key = each.key;
		const Vector &target = each.target;
		Document document;
		REQUIRE(document.add("x", text));
		const std::optional<Handle> found = find(document, "x", key);
		REQUIRE_MESSAGE(found, std::string(text));
		const Handle &start = *found;
		const bool is_free = start.constraint.motion == Motion::FREE;
		const ViewRay ray = through(target);
		const std::optional<Drag> result = drag(document, "x", start, ray);
		REQUIRE_MESSAGE(result, std::string(text), " ", std::string(key));
		const std::optional<Vector> position = position_on(ray, start.constraint);
		REQUIRE(position);
		CHECK(distance(ray, *position) < 1e-9);
		CHECK_MESSAGE((is_free || glm::distance(*position, target) < 1e-6), text, " ", key);
		const ChangeResult change = document.set_parameter("x", result->parameter, result->value);
		REQUIRE_MESSAGE(change, text, " ", key, ": ", change.error().message);
		const std::optional<Handle> end = find(document, "x", key);
		REQUIRE_MESSAGE(end, text, " ", key);
		// Expressions keep seven digits.
		CHECK_MESSAGE(distance(ray, end->constraint.position) < 3e-6, text, " ", key, " is now ", document.find("x")->text);
	}
}

TEST_CASE("a drag rewrites literals, rounded to the steps") {
	const Steps steps{ 0.1, 15.0 * DEGREE };
	const ViewRay straight{ { 2.34, 5.0, -1.27 }, { 0.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 } };
	CHECK(dragged("point( 1, 2,3 )", "position", straight, steps) == "point( 2.3, 2,-1.3 )");
	CHECK(dragged("point( 1, 2,3 )", "position", straight) == "point( 2.34, 2,-1.27 )");
	// The coordinate along the view direction is not rounded.
	CHECK(dragged("point(1, 2.06, 3)", "position", straight, steps) == "point(2.3, 2.06, -1.3)");
	CHECK(dragged("sphere(point(1, 2, 3), 2)", "radius", { { 2.66, 2.0, 9.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 1.0 } }, steps) == "sphere(point(1, 2, 3), 1.7)");
	CHECK(dragged("plane(e2, 1)", "distance", through({ 0.0, -2.02, 0.0 }), steps) == "plane(e2, -2)");
	CHECK(dragged("circle(0, e3, 1)", "normal", through({ 0.05, 0.99, 0.02 }), steps) == "circle(0, e2, 1)");
	CHECK(dragged("rotor(e3, deg(90))", "angle", through({ 0.65 * std::cos(32.0 * DEGREE), 0.65 * std::sin(32.0 * DEGREE), 0.0 }), steps) == "rotor(e3, deg(30))");
	CHECK(dragged("rotor(e3, deg(350))", "angle", through({ 0.65 * std::cos(29.0 * DEGREE), 0.65 * std::sin(29.0 * DEGREE), 0.0 }), steps) == "rotor(e3, deg(390))");
	CHECK(dragged("motor(0, rotor(e3, deg(90)), 2)", "scale", through({ -0.43, 0.43, 0.43 }), steps) == "motor(0, rotor(e3, deg(90)), 1.5)");
	CHECK(dragged("e1 + 0.5 einf + eo", "object", straight, { 1.0, 0.0 }) == "2 e1 - e3 + 2 e4 + 3 e5");
}

TEST_CASE("the only literal coordinate of a point can be dragged") {
	Document document;
	REQUIRE(document.add("t", "2"));
	REQUIRE(document.add("x", "point(t, 1, t + 1)"));
	const std::optional<Handle> start = find(document, "x", "y");
	REQUIRE(start);
	const std::optional<Drag> result = drag(document, "x", *start, through({ 2.0, -1.52, 3.0 }), { 0.1, 0.0 });
	REQUIRE(result);
	REQUIRE(document.set_parameter("x", result->parameter, result->value));
	CHECK(document.find("x")->text == "point(t, -1.5, t + 1)");
}

TEST_CASE("repeated drags of a handle to one ray, with a step, give the same position") {
	Document document;
	REQUIRE(document.add("x", "point(1, 2, 3)"));
	const Handle start = *find(document, "x", "position");
	std::string first;
	for (int i = 0; i < 50; ++i) {
		const std::optional<Drag> result = drag(document, "x", start, through({ 0.3, 0.2, 0.1 }), { 0.5, 0.0 });
		REQUIRE(result);
		REQUIRE(document.set_parameter("x", result->parameter, result->value));
		first = first.empty() ? document.find("x")->text : first;
		CHECK(document.find("x")->text == first);
	}
}

TEST_CASE("the grabbed point stays under the mouse") {
	Document document;
	REQUIRE(document.add("x", "sphere(point(1, 2, 3), 2)"));
	Handle start = *find(document, "x", "center");
	start.grab = { 0.0, 1.2, 1.6 };
	const ViewRay ray{ { 5.0, 7.0, 20.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, -1.0 } };
	const std::optional<Drag> result = drag(document, "x", start, ray);
	REQUIRE(result);
	CHECK(glm::distance(*std::get_if<Vector>(&result->value), Vector(5.0, 5.8, 3.0)) < 1e-9);
}

TEST_CASE("a handle does not follow a ray without a valid position") {
	const ViewRay behind{ { 0.0, 0.0, -10.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, -1.0 } };
	for (const auto &[text, key] : { std::pair<const char *, const char *>{ "point(1, 2, 3)", "position" }, { "sphere(e1, 2)", "radius" }, { "circle(e1, e2, 2)", "normal" }, { "plane(e1, 1)", "distance" }, { "motor(e1, rotor(e1, 1), 2)", "angle" } }) {
		CHECK(dragged(text, key, behind) == text);
		CHECK(dragged(text, key, { {}, {}, {} }) == text);
		CHECK(dragged(text, key, { { NAN, 0.0, 0.0 }, { NAN, 1.0, 0.0 }, { 1.0, 0.0, 0.0 } }) == text);
	}
	// Beyond the center a radius would be negative. With a step, the smallest radius is the step.
	CHECK(dragged("sphere(0, 2)", "radius", through({ -1.0, 0.0, 0.0 })) == "sphere(0, 2)");
	CHECK(dragged("sphere(0, 2)", "radius", through({ -1.0, 0.0, 0.0 }), { 0.1, 0.0 }) == "sphere(0, 0.1)");
	CHECK(dragged("motor(0, 1, 2)", "scale", through({ -1.0, -1.0, -1.0 })) == "motor(0, 1, 2)");
}

TEST_CASE("a handle that no longer exists does not follow") {
	Document document;
	REQUIRE(document.add("x", "sphere(e1, 2)"));
	const Handle start = *find(document, "x", "radius");
	REQUIRE(document.set_expression("x", "sphere(e1, k)"));
	CHECK_FALSE(drag(document, "x", start, through({ 3.0, 0.0, 0.0 })));
	REQUIRE(document.set_expression("x", "point(1, 2, 3)"));
	CHECK_FALSE(drag(document, "x", start, through({ 3.0, 0.0, 0.0 })));
	REQUIRE(document.remove("x"));
	CHECK_FALSE(drag(document, "x", start, through({ 3.0, 0.0, 0.0 })));
}

TEST_CASE("dependent entries follow a drag") {
	Document document;
	REQUIRE(document.add("A", "point(0, 0, 0)"));
	REQUIRE(document.add("s", "sphere(A, 1)"));
	REQUIRE(document.add("l", "line(A, e1)"));
	const Handle start = *find(document, "A", "position");
	const std::optional<Drag> result = drag(document, "A", start, { { 1.5, 2.0, 10.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 0.0, -1.0 } });
	REQUIRE(result);
	const ChangeResult change = document.set_parameter("A", result->parameter, result->value);
	CHECK(*change == std::vector<std::string>{ "A", "s", "l" });
	CHECK(document.find("A")->text == "point(1.5, 2, 0)");
	CHECK(glm::distance(handles_of(document, "s")[0].stem, Vector(1.5, 2.0, 0.0)) < 1e-9);
}
