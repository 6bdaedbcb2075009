#include "playground/expression/function_table.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"

namespace playground {

namespace {

template <cga::MultivectorResult (*FUNCTION)(const cga::Multivector &, const cga::Multivector &)>
FunctionResult of_two(const Arguments &arguments) {
	return FUNCTION(arguments[0], arguments[1]);
}

// Calls a constructor with the locations of the arguments at INDICES.
template <auto FUNCTION, size_t... INDICES>
FunctionResult at_locations(const Arguments &arguments) {
	return FUNCTION(arguments.location(INDICES)...);
}

// All objects are OPNS. If overloads of `line` or `circle` take the same number of arguments, the one with a direction comes
// first: two vectors are a point and a direction, as in the Multivector class.
constexpr Overload TABLE[] = {
	{ "point", "position", 1, { P }, [](const Arguments &a) -> FunctionResult { return cga::point(a.location(0)); }, "the point at a position" },
	{ "point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> FunctionResult { return cga::point(a.numbers(0)); }, "the point (x, y, z)" },
	{ "flat_point", "position", 1, { P }, [](const Arguments &a) -> FunctionResult { return cga::flat_point(a.location(0)); }, "the flat point at a position, such as the intersection of a line and a plane" },
	{ "flat_point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> FunctionResult { return cga::flat_point(a.numbers(0)); }, "the flat point at (x, y, z)" },
	{ "point_pair", "a, b", 2, { P, P }, at_locations<cga::point_pair, 0, 1>, "the pair of points a and b" },
	{ "pair", "a, b", 2, { P, P }, at_locations<cga::point_pair, 0, 1>, "the same as point_pair" },
	{ "line", "point, direction", 2, { P, V }, [](const Arguments &a) -> FunctionResult { return cga::line(a.location(0), a.vector(1)); }, "the line through a point in a direction" },
	{ "line", "a, b", 2, { P, P }, at_locations<cga::line_through, 0, 1>, "the line from a through b, where b is a point, not a vector" },
	{ "line_through", "a, b", 2, { P, P }, at_locations<cga::line_through, 0, 1>, "the line from a through b" },
	{ "circle", "center, normal, radius", 3, { P, V, N }, [](const Arguments &a) -> FunctionResult { return cga::circle(a.location(0), a.vector(1), a.number(2)); }, "the circle around a center, perpendicular to a normal" },
	{ "circle", "a, b, c", 3, { P, P, P }, at_locations<cga::circle_through, 0, 1, 2>, "the circle through three points" },
	{ "circle_through", "a, b, c", 3, { P, P, P }, at_locations<cga::circle_through, 0, 1, 2>, "the circle through three points; their line if they are collinear" },
	{ "plane", "normal, distance", 2, { V, N }, [](const Arguments &a) -> FunctionResult { return cga::plane(a.vector(0), a.number(1)); }, "the plane perpendicular to a normal, at a signed distance from the origin along it" },
	{ "plane", "a, b, c", 3, { P, P, P }, at_locations<cga::plane_through, 0, 1, 2>, "the plane through three points" },
	{ "plane", "x, y, z, distance", 4, { N, N, N, N }, [](const Arguments &a) -> FunctionResult { return cga::plane(a.numbers(0), a.number(3)); }, "the plane perpendicular to the normal (x, y, z), at a signed distance" },
	{ "plane_through", "a, b, c", 3, { P, P, P }, at_locations<cga::plane_through, 0, 1, 2>, "the plane through three points" },
	{ "sphere", "center, radius", 2, { P, N }, [](const Arguments &a) -> FunctionResult { return cga::sphere(a.location(0), a.number(1)); }, "the sphere around a center" },
	{ "sphere", "x, y, z, radius", 4, { N, N, N, N }, [](const Arguments &a) -> FunctionResult { return cga::sphere(a.numbers(0), a.number(3)); }, "the sphere around (x, y, z)" },
	{ "sphere", "a, b, c, d", 4, { P, P, P, P }, at_locations<cga::sphere_through, 0, 1, 2, 3>, "the sphere through four points" },
	{ "sphere_through", "a, b, c, d", 4, { P, P, P, P }, at_locations<cga::sphere_through, 0, 1, 2, 3>, "the sphere through four points; their plane if they are coplanar" },
	{ "imaginary_point_pair", "center, direction, radius", 3, { P, V, N }, [](const Arguments &a) -> FunctionResult { return cga::imaginary_point_pair(a.location(0), a.vector(1), a.number(2)); }, "an imaginary point pair: its squared radius is -radius^2" },
	{ "imaginary_circle", "center, normal, radius", 3, { P, V, N }, [](const Arguments &a) -> FunctionResult { return cga::imaginary_circle(a.location(0), a.vector(1), a.number(2)); }, "an imaginary circle: its squared radius is -radius^2" },
	{ "imaginary_sphere", "center, radius", 2, { P, N }, [](const Arguments &a) -> FunctionResult { return cga::imaginary_sphere(a.location(0), a.number(1)); }, "an imaginary sphere: its squared radius is -radius^2" },
	{ "tangent_along", "point, direction", 2, { P, V }, [](const Arguments &a) -> FunctionResult { return cga::tangent_along(a.location(0), a.vector(1)); }, "the tangent at a point, along a direction" },
	{ "tangent_across", "point, normal", 2, { P, V }, [](const Arguments &a) -> FunctionResult { return cga::tangent_across(a.location(0), a.vector(1)); }, "the tangent at a point, perpendicular to a normal" },
	{ "direction", "vector", 1, { V }, [](const Arguments &a) -> FunctionResult { return cga::direction(a.vector(0)); }, "the direction that parallel lines share" },
	{ "direction_across", "normal", 1, { V }, [](const Arguments &a) -> FunctionResult { return cga::direction_across(a.vector(0)); }, "the direction that parallel planes share" },

	{ "meet", "x, y", 2, { X, X }, of_two<cga::meet>, "the intersection of two objects" },
	{ "join", "x, y", 2, { X, X }, of_two<cga::join>, "the smallest object that contains both" },
	{ "project_onto", "x, onto", 2, { X, X }, of_two<cga::project_onto>, "x projected onto another object" },
	{ "reject_from", "x, from", 2, { X, X }, of_two<cga::reject_from>, "the part of x perpendicular to another object" },
	{ "reflect_in", "x, mirror", 2, { X, X }, of_two<cga::reflect_in>, "x reflected in another object" },
};

} // namespace

FunctionTable object_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
