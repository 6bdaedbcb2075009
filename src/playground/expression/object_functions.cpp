#include "playground/expression/function_table.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"

namespace playground {

namespace {

template <cga::Result<cga::Multivector> (*function)(const cga::Multivector &, const cga::Multivector &)>
Outcome of_two(const Arguments &arguments) {
	return function(arguments[0], arguments[1]);
}

Outcome call_line_through(const Arguments &a) {
	return cga::line_through(a.location(0), a.location(1));
}

Outcome call_point_pair(const Arguments &a) {
	return cga::point_pair(a.location(0), a.location(1));
}

Outcome call_circle_through(const Arguments &a) {
	return cga::circle_through(a.location(0), a.location(1), a.location(2));
}

Outcome call_plane_through(const Arguments &a) {
	return cga::plane_through(a.location(0), a.location(1), a.location(2));
}

Outcome call_sphere_through(const Arguments &a) {
	return cga::sphere_through(a.location(0), a.location(1), a.location(2), a.location(3));
}

// All objects are OPNS. Of the two ways to call `line` and `circle` with as many arguments, the one by a vector stands
// first: two vectors are a point and a direction, as in the Multivector class.
constexpr Overload TABLE[] = {
	{ "point", "position", 1, { P }, [](const Arguments &a) -> Outcome { return cga::point(a.location(0)); }, "the point at a position" },
	{ "point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> Outcome { return cga::point(a.numbers(0)); }, "the point (x, y, z)" },
	{ "flat_point", "position", 1, { P }, [](const Arguments &a) -> Outcome { return cga::flat_point(a.location(0)); }, "a point and infinity: where lines and planes meet" },
	{ "flat_point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> Outcome { return cga::flat_point(a.numbers(0)); }, "the same at (x, y, z)" },
	{ "point_pair", "a, b", 2, { P, P }, call_point_pair, "the pair of two points" },
	{ "pair", "a, b", 2, { P, P }, call_point_pair, "the same as point_pair" },
	{ "line", "point, direction", 2, { P, V }, [](const Arguments &a) { return cga::line(a.location(0), a.vector(1)); }, "the line through a point in a direction" },
	{ "line", "a, b", 2, { P, P }, call_line_through, "the line through two points, from a to b; b a point, not a vector" },
	{ "line_through", "a, b", 2, { P, P }, call_line_through, "the line through two points, from a to b" },
	{ "circle", "center, normal, radius", 3, { P, V, N }, [](const Arguments &a) { return cga::circle(a.location(0), a.vector(1), a.number(2)); }, "the circle about a center, across a normal" },
	{ "circle", "a, b, c", 3, { P, P, P }, call_circle_through, "the circle through three points" },
	{ "circle_through", "a, b, c", 3, { P, P, P }, call_circle_through, "the circle through three points; their line, if they are on one" },
	{ "plane", "normal, distance", 2, { V, N }, [](const Arguments &a) { return cga::plane(a.vector(0), a.number(1)); }, "the plane across a normal, at a distance from the origin along it" },
	{ "plane", "a, b, c", 3, { P, P, P }, call_plane_through, "the plane through three points" },
	{ "plane", "x, y, z, distance", 4, { N, N, N, N }, [](const Arguments &a) { return cga::plane(a.numbers(0), a.number(3)); }, "the plane across the normal (x, y, z)" },
	{ "plane_through", "a, b, c", 3, { P, P, P }, call_plane_through, "the plane through three points" },
	{ "sphere", "center, radius", 2, { P, N }, [](const Arguments &a) { return cga::sphere(a.location(0), a.number(1)); }, "the sphere about a center" },
	{ "sphere", "x, y, z, radius", 4, { N, N, N, N }, [](const Arguments &a) { return cga::sphere(a.numbers(0), a.number(3)); }, "the sphere about (x, y, z)" },
	{ "sphere", "a, b, c, d", 4, { P, P, P, P }, call_sphere_through, "the sphere through four points" },
	{ "sphere_through", "a, b, c, d", 4, { P, P, P, P }, call_sphere_through, "the sphere through four points; their plane, if they are on one" },
	{ "imaginary_point_pair", "center, direction, radius", 3, { P, V, N }, [](const Arguments &a) { return cga::imaginary_point_pair(a.location(0), a.vector(1), a.number(2)); }, "a pair of squared radius -radius^2" },
	{ "imaginary_circle", "center, normal, radius", 3, { P, V, N }, [](const Arguments &a) { return cga::imaginary_circle(a.location(0), a.vector(1), a.number(2)); }, "a circle of squared radius -radius^2" },
	{ "imaginary_sphere", "center, radius", 2, { P, N }, [](const Arguments &a) { return cga::imaginary_sphere(a.location(0), a.number(1)); }, "a sphere of squared radius -radius^2" },
	{ "tangent_along", "point, direction", 2, { P, V }, [](const Arguments &a) { return cga::tangent_along(a.location(0), a.vector(1)); }, "a point with a direction" },
	{ "tangent_across", "point, normal", 2, { P, V }, [](const Arguments &a) { return cga::tangent_across(a.location(0), a.vector(1)); }, "a point with a plane through it" },
	{ "direction", "vector", 1, { V }, [](const Arguments &a) { return cga::direction(a.vector(0)); }, "what parallel lines have in common" },
	{ "direction_across", "normal", 1, { V }, [](const Arguments &a) { return cga::direction_across(a.vector(0)); }, "what parallel planes have in common" },

	{ "meet", "x, y", 2, { X, X }, of_two<cga::meet>, "what two objects have in common" },
	{ "join", "x, y", 2, { X, X }, of_two<cga::join>, "the smallest object that holds both" },
	{ "project_onto", "x, onto", 2, { X, X }, of_two<cga::project_onto>, "the part of x in another object" },
	{ "reject_from", "x, from", 2, { X, X }, of_two<cga::reject_from>, "the part of x outside of another object" },
	{ "reflect_in", "x, mirror", 2, { X, X }, of_two<cga::reflect_in>, "x reflected in another object" },
};

} // namespace

FunctionTable object_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
