#include "playground/handles/handles.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace playground;
using namespace playground::handles;

namespace {

std::vector<Handle> handles_for(const char *text, const Vector &right = { 1.0, 0.0, 0.0 }) {
	Document document;
	REQUIRE(document.add("A", "point(0, 3, 0)"));
	REQUIRE(document.add("k", "2"));
	REQUIRE(document.add("v", "3 e2"));
	REQUIRE(document.add("x", text));
	return handles_of(document, "x", right);
}

std::string keys(const char *text) {
	std::string all;
	for (const Handle &handle : handles_for(text)) {
		all += (all.empty() ? "" : " ") + handle.key;
	}
	return all;
}

Handle handle(const char *text, const char *key, const Vector &right = { 1.0, 0.0, 0.0 }) {
	for (const Handle &found : handles_for(text, right)) {
		if (found.key == key) {
			return found;
		}
	}
	FAIL(std::string(text), " has no handle ", std::string(key));
	return {};
}

bool is_near(const Vector &left, const Vector &right) {
	return glm::length(left - right) < 1e-9;
}

} // namespace

TEST_CASE("the handles of each constructor") {
	CHECK(keys("point(1, 2, 3)") == "position");
	CHECK(keys("flat_point(e1)") == "position");
	CHECK(keys("point(k, 1, k)") == "y");
	CHECK(keys("point(k, 1, 2)") == "");
	CHECK(keys("sphere(k, k, 1, 2)") == "z radius");
	CHECK(keys("plane(k, 1, k, k)") == "");
	CHECK(keys("point_pair(e1, e2)") == "a b");
	CHECK(keys("line(point(1, 2, 3), e1)") == "point direction");
	CHECK(keys("line_through(e1, A)") == "a");
	CHECK(keys("circle(e1, e2, 2)") == "center radius normal");
	CHECK(keys("circle(point(1, 0, 0), point(0, 1, 0), A)") == "a b");
	CHECK(keys("plane(e3, 1)") == "distance normal");
	CHECK(keys("plane(point(1, 0, 0), A, point(0, 0, 1))") == "a c");
	CHECK(keys("sphere(e1, 2)") == "center radius");
	CHECK(keys("!sphere(e1, 2)") == "center radius");
	CHECK(keys("sphere(A, 2)") == "radius");
	CHECK(keys("sphere(e1, k)") == "center");
	CHECK(keys("sphere_through(e1, e2, e3, 0)") == "a b c d");
	CHECK(keys("imaginary_sphere(e1, 2)") == "center radius");
	CHECK(keys("imaginary_point_pair(e1, e2, 2)") == "center radius direction");
	CHECK(keys("tangent_along(e1, e2)") == "point direction");
	CHECK(keys("tangent_across(e1, e2)") == "point normal");
	CHECK(keys("direction(e1)") == "vector");
	CHECK(keys("translator(1, 2, 3)") == "offset");
	CHECK(keys("dilator(2)") == "scale");
	CHECK(keys("rotor(e3, deg(90))") == "axis angle");
	CHECK(keys("rotor(0, 0, 0.6, 0.8)") == "axis angle");
	CHECK(keys("rotor(0, 0, 0, 1)") == "angle");
	CHECK(keys("motor(e1, rotor(e3, deg(90)), 2)") == "translation axis angle scale");
	CHECK(keys("motor(v, rotor(e3, deg(90)))") == "axis angle");
	CHECK(keys("motor(e1, 1)") == "translation angle");
}

TEST_CASE("objects written as sums of blades move as a whole") {
	CHECK(keys("e1 + 0.5 einf + eo") == "object");
	CHECK(is_near(handle("e2 + 0.5 einf + eo", "object").constraint.position, { 0.0, 1.0, 0.0 }));
	const Handle plane = handle("2 e1245", "object"); // the plane through the origin with normal e3
	CHECK(plane.constraint.motion == Motion::LINE);
	CHECK(std::abs(plane.constraint.axis.z) == doctest::Approx(1.0));
}

TEST_CASE("computed entries and entries without a value or position have no handles") {
	CHECK(keys("2.5") == "");
	CHECK(keys("sphere(e1, -2)") == "");
	CHECK(keys("sphere(A, k)") == "");
	CHECK(keys("A ^ einf") == "");
	CHECK(keys("1 + e1") == "");
	CHECK(keys("point(1, 2") == "");
	CHECK(keys("point(1e12, 0, 0)") == "");
	CHECK(keys("~motor(e1, rotor(e3, 1))") == "");
	CHECK(keys("~translator(e1)") == "");
	CHECK(handles_of(Document(), "nothing").empty());
}

TEST_CASE("positions of handles, and which ones move the object") {
	CHECK(is_near(handle("point(1, 2, 3)", "position").constraint.position, { 1.0, 2.0, 3.0 }));
	CHECK(handle("point(1, 2, 3)", "position").moves_body);
	CHECK_FALSE(handle("pair(e1, e2)", "a").moves_body);
	const Handle radius = handle("sphere(A, 2)", "radius", { 0.0, 0.0, -1.0 });
	CHECK(is_near(radius.constraint.position, { 0.0, 3.0, -2.0 }));
	CHECK(is_near(radius.stem, { 0.0, 3.0, 0.0 }));
	// In the plane of the circle, even if `right` is along the normal.
	CHECK(is_near(handle("circle(A, e2, 2)", "radius", { 0.6, 0.8, 0.0 }).constraint.position, { 2.0, 3.0, 0.0 }));
	CHECK(handle("circle(A, e2, 2)", "radius", { 0.0, 1.0, 0.0 }).constraint.position.y == doctest::Approx(3.0));
	CHECK(is_near(handle("circle(A, 2 e2, 2)", "normal").constraint.position, { 0.0, 4.0, 0.0 }));
	CHECK(is_near(handle("plane(2 e3, 1.5)", "distance").constraint.position, { 0.0, 0.0, 1.5 }));
	CHECK(is_near(handle("plane(e3, k)", "normal").constraint.position, { 0.0, 0.0, 3.0 }));
	// The arm points away from the origin, about which the plane rotates.
	CHECK(is_near(handle("plane(e3, -1)", "normal").constraint.position, { 0.0, 0.0, -2.0 }));
	CHECK(is_near(handle("line(A, e1)", "direction").constraint.position, { 1.0, 3.0, 0.0 }));
	const char *motor = "motor(e1, rotor(e3, deg(90)), 2)";
	CHECK(is_near(handle(motor, "translation").constraint.position, { 1.0, 0.0, 0.0 }));
	CHECK(is_near(handle(motor, "axis").constraint.position, { 1.0, 0.0, 1.0 }));
	CHECK(is_near(handle(motor, "angle").constraint.position, { 1.0, 0.65, 0.0 }));
	const double third = 1.0 / std::sqrt(3.0);
	CHECK(is_near(handle(motor, "scale").constraint.position, { 1.0 - third, third, third }));
	CHECK(is_near(handle("motor(v, rotor(e3, 1))", "axis").constraint.position, { 0.0, 3.0, 1.0 }));
}
