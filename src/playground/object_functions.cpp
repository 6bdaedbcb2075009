#include "playground/function_table.hpp"

#include "cga/motor/versor.hpp"
#include "playground/object_incidence.hpp"
#include "playground/object_shapes.hpp"

namespace playground {

namespace {

template <cga::Result<cga::Multivector> (*function)(const cga::Multivector &, const cga::Multivector &)>
Outcome of_two(const Arguments &arguments) {
	return function(arguments[0], arguments[1]);
}

Outcome call_line_through(const Arguments &a) {
	return playground::line_through(a.location(0), a.location(1));
}

Outcome call_point_pair(const Arguments &a) {
	return playground::point_pair(a.location(0), a.location(1));
}

Outcome call_circle_through(const Arguments &a) {
	return playground::circle_through(a.location(0), a.location(1), a.location(2));
}

Outcome call_plane_through(const Arguments &a) {
	return playground::plane_through(a.location(0), a.location(1), a.location(2));
}

Outcome call_sphere_through(const Arguments &a) {
	return playground::sphere_through(a.location(0), a.location(1), a.location(2), a.location(3));
}

// All objects are OPNS. Of the two ways to call `line` and `circle` with as many arguments, the one by a vector stands
// first: two vectors are a point and a direction, as in the Multivector class.
constexpr Overload TABLE[] = {
	{ "point", "position", 1, { P }, [](const Arguments &a) -> Outcome { return cga::point(a.location(0)); }, "the point at a position" },
	{ "point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> Outcome { return cga::point(a.numbers(0)); }, "the point (x, y, z)" },
	{ "flat_point", "position", 1, { P }, [](const Arguments &a) -> Outcome { return playground::flat_point(a.location(0)); }, "a point and infinity: where lines and planes meet" },
	{ "flat_point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> Outcome { return playground::flat_point(a.numbers(0)); }, "the same at (x, y, z)" },
	{ "point_pair", "a, b", 2, { P, P }, call_point_pair, "the pair of two points" },
	{ "pair", "a, b", 2, { P, P }, call_point_pair, "the same as point_pair" },
	{ "line", "point, direction", 2, { P, V }, [](const Arguments &a) { return playground::line(a.location(0), a.vector(1)); }, "the line through a point in a direction" },
	{ "line", "a, b", 2, { P, P }, call_line_through, "the line through two points, from a to b; b a point, not a vector" },
	{ "line_through", "a, b", 2, { P, P }, call_line_through, "the line through two points, from a to b" },
	{ "circle", "center, normal, radius", 3, { P, V, N }, [](const Arguments &a) { return playground::circle(a.location(0), a.vector(1), a.number(2)); }, "the circle about a center, across a normal" },
	{ "circle", "a, b, c", 3, { P, P, P }, call_circle_through, "the circle through three points" },
	{ "circle_through", "a, b, c", 3, { P, P, P }, call_circle_through, "the circle through three points; their line, if they are on one" },
	{ "plane", "normal, distance", 2, { V, N }, [](const Arguments &a) { return playground::plane(a.vector(0), a.number(1)); }, "the plane across a normal, at a distance from the origin along it" },
	{ "plane", "a, b, c", 3, { P, P, P }, call_plane_through, "the plane through three points" },
	{ "plane", "x, y, z, distance", 4, { N, N, N, N }, [](const Arguments &a) { return playground::plane(a.numbers(0), a.number(3)); }, "the plane across the normal (x, y, z)" },
	{ "plane_through", "a, b, c", 3, { P, P, P }, call_plane_through, "the plane through three points" },
	{ "sphere", "center, radius", 2, { P, N }, [](const Arguments &a) { return playground::sphere(a.location(0), a.number(1)); }, "the sphere about a center" },
	{ "sphere", "x, y, z, radius", 4, { N, N, N, N }, [](const Arguments &a) { return playground::sphere(a.numbers(0), a.number(3)); }, "the sphere about (x, y, z)" },
	{ "sphere", "a, b, c, d", 4, { P, P, P, P }, call_sphere_through, "the sphere through four points" },
	{ "sphere_through", "a, b, c, d", 4, { P, P, P, P }, call_sphere_through, "the sphere through four points; their plane, if they are on one" },

	{ "meet", "x, y", 2, { X, X }, of_two<playground::meet>, "what two objects have in common" },
	{ "join", "x, y", 2, { X, X }, of_two<playground::join>, "the smallest object that contains both" },
	{ "project_onto", "x, onto", 2, { X, X }, of_two<playground::project_onto>, "the part of x in another object" },
	{ "reject_from", "x, from", 2, { X, X }, of_two<playground::reject_from>, "the part of x outside of another object" },
	{ "reflect_in", "x, mirror", 2, { X, X }, of_two<playground::reflect_in>, "x reflected in another object" },
};

} // namespace

FunctionTable object_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
