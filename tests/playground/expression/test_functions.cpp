#include "playground/expression/functions.hpp"

#include "cga/text/text.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/parser.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace playground;
using cga::Multivector;

namespace {

struct Case {
	std::string expression;
	std::string expected; // an expression with the same value
};

// Known values, or values from another formula than that of the tested function.
const std::vector<Case> CASES = {
	{ "sin(pi / 6)", "0.5" },
	{ "cos(pi)", "-1" },
	{ "tan(pi / 4)", "1" },
	{ "asin(1)", "pi / 2" },
	{ "acos(-1)", "pi" },
	{ "atan(1)", "pi / 4" },
	{ "atan2(1, -1)", "3 * pi / 4" },
	{ "atan2(0, 0)", "0" },
	{ "sinh(1)", "1.1752011936438014" },
	{ "cosh(1)", "1.5430806348152437" },
	{ "tanh(1)", "0.7615941559557649" },
	{ "exp(1)", "2.718281828459045" },
	{ "log(exp(3))", "3" },
	{ "sqrt(2)", "1.4142135623730951" },
	{ "power(2, 10)", "1024" },
	{ "power(-2, 3)", "-8" },
	{ "power(4, -0.5)", "0.5" },
	{ "abs(-3)", "3" },
	{ "sign(-3) + 10 * sign(0) + 100 * sign(2)", "99" },
	{ "floor(-1.5)", "-2" },
	{ "ceil(-1.5)", "-1" },
	{ "round(2.5)", "3" },
	{ "min(2, 1) + min(1, 2, 3) + min(4, 3, 2, 1)", "3" },
	{ "max(2, 1) + max(1, 2, 3) + max(4, 3, 2, 1)", "9" },
	{ "clamp(5, 0, 2) + clamp(-5, 0, 2) + clamp(1, 0, 2)", "3" },
	{ "deg_to_rad(180)", "pi" },
	{ "deg(90)", "pi / 2" },
	{ "rad_to_deg(pi)", "180" },

	{ "scalar(3)", "3" },
	{ "basis_blade(0) + basis_blade(6) + basis_blade(31)", "1 + e12 + e12345" },
	{ "vector(1, 2, 3)", "e1 + 2 e2 + 3 e3" },
	{ "add(e1, 2)", "2 + e1" },
	{ "subtract(e1, 2)", "e1 - 2" },
	{ "scaled(e1 + e23, 3)", "3 e1 + 3 e23" },
	{ "geometric_product(e1, e1 + e2)", "1 + e12" },
	{ "outer_product(e1, e1 + e2)", "e12" },
	{ "inner_product(e1, e1 + e2)", "1" },
	{ "inner_product(2, e12)", "2 e12" },
	{ "left_contraction(e1, e12)", "e2" },
	{ "right_contraction(e12, e2)", "e1" },
	{ "left_contraction(e12, e1)", "0" },
	{ "regressive_product(e1234, e2345)", "undual(dual(e1234) ^ dual(e2345))" },
	{ "commutator_product(e12, e23)", "(e12 * e23 - e23 * e12) / 2" },
	{ "scalar_product(e12, e12)", "-1" },
	{ "reverse(1 + e1 + e12 + e123 + e1234 + I)", "1 + e1 - e12 - e123 + e1234 + I" },
	{ "grade_involution(1 + e1 + e12 + e123 + e1234 + I)", "1 - e1 + e12 - e123 + e1234 - I" },
	{ "clifford_conjugate(1 + e1 + e12 + e123 + e1234 + I)", "1 - e1 - e12 + e123 + e1234 - I" },
	{ "dual(e1)", "e1 * -I" },
	{ "undual(e1)", "e1 * I" },
	{ "grade(1 + e1 + 3 e12, 2)", "3 e12" },
	{ "inverse(2 e5)", "-0.5 e5" },
	{ "inverse(2 + e1)", "(2 - e1) / 3" },
	{ "norm(3 e1 + 4 e2)", "5" },
	{ "norm_squared(e5)", "-1" },
	{ "normalized(3 e1 + 4 e2)", "0.6 e1 + 0.8 e2" },
	{ "normalize(3 e12)", "e12" },
	{ "is_equal_approx(1, 1 + 1e-10) + 10 * is_equal_approx(1, 1.1)", "1" },
	{ "is_blade(e12 + e13) + 10 * is_blade(e12 + e34)", "1" },
	{ "is_versor(e1 * (e2 + e3)) + 10 * is_versor(1 + e1)", "1" },
	{ "is_motor(translator(e1)) + 10 * is_motor(e1)", "1" },

	{ "point(1, 2, 3)", "e1 + 2 e2 + 3 e3 + 7 einf + eo" },
	{ "point(e1 + e2)", "e1 + e2 + einf + eo" },
	{ "point(-2 point(1, 2, 3))", "point(1, 2, 3)" },
	{ "flat_point(e1)", "point(1, 0, 0) ^ einf" },
	{ "flat_point(1, 2, 3)", "point(1, 2, 3) ^ einf" },
	{ "point_pair(e1, point(1, 2, 3))", "point(1, 0, 0) ^ point(1, 2, 3)" },
	{ "pair(eo, e1)", "point_pair(eo, e1)" },
	{ "line(eo, e1)", "line_through(eo, e1)" },
	{ "line(e2, 5 e1)", "line(e2, point(1, 1, 0))" },
	{ "line_through(e1, e2)", "point(e1) ^ point(e2) ^ einf" },
	{ "circle(e1, 3 e3, 2)", "circle_through(3 e1, e1 + 2 e2, -e1) / 8" },
	{ "circle(e1, e2, e3)", "point(e1) ^ point(e2) ^ point(e3)" },
	{ "circle_through(0, e1, 3 e1)", "3 line_through(0, e1)" },
	{ "plane(2 e3, 3)", "plane_through(3 e3, 3 e3 + e1, 3 e3 + e2)" },
	{ "plane(e1, e2, e3)", "plane_through(e1, e2, e3)" },
	{ "plane(0, 0, 5, 3)", "plane(e3, 3)" },
	{ "plane_through(e1, e2, e3)", "point(e1) ^ point(e2) ^ point(e3) ^ einf" },
	{ "sphere(0, 1)", "sphere_through(-e1, e1, e2, e3) / 2" },
	{ "sphere(1, 2, 3, 2)", "sphere(point(1, 2, 3), 2)" },
	{ "sphere(e1, e2, e3, 0)", "sphere_through(e1, e2, e3, 0)" },
	{ "sphere_through(e1, e2, e3, 0)", "point(e1) ^ point(e2) ^ point(e3) ^ eo" },
	{ "dual(sphere(e1, 2)) * dual(sphere(e1, 2))", "4" },
	{ "point(3, 0, 0) ^ sphere(e1, 2)", "0" },
	{ "point(3, 0, 0) ^ circle(e1, e3, 2)", "0" },
	{ "point(7, 8, 2) ^ plane(e3, 2)", "0" },
	{ "power(norm(dual(imaginary_sphere(e1, 2))), 2)", "4" },
	{ "norm_squared(dual(imaginary_circle(e1, e3, 2)))", "-norm_squared(dual(circle(e1, e3, 2)))" },
	{ "norm_squared(imaginary_point_pair(e1, e3, 2))", "-norm_squared(point_pair(e1 - 2 e3, e1 + 2 e3)) / 16" },
	{ "tangent_along(e1, e2) ^ point(e1)", "0" },
	{ "tangent_across(e1, e2) ^ point(e1)", "0" },
	{ "direction(3 e1) ^ einf", "0" },
	{ "direction_across(3 e1) ^ e23", "0" },
	// Crossing lines meet in a flat point and join in a plane; a line in a plane is their meet.
	{ "meet(line(0, e1), line(0, e2)) ^ flat_point(0, 0, 0)", "0" },
	{ "norm(grade(meet(line(e2, e1), line(e1, e2)), 2)) * norm(flat_point(e1 + e2))", "norm(meet(line(e2, e1), line(e1, e2)))" },
	{ "normalized(join(line(0, e1), line(0, e2)))", "plane(e3, 0)" },
	{ "normalized(meet(line(0, e1), plane(e3, 0)))", "line(0, e1)" },
	{ "normalized(meet(plane(e1, 1), plane(e2, 2))) ^ point(1, 2, 7)", "0" },
	{ "meet(sphere(0, 1), sphere(e1, 1)) ^ point(0.5, sqrt(0.75), 0)", "0" },
	{ "grade(meet(sphere(0, 1), sphere(e1, 1)), 3) - meet(sphere(0, 1), sphere(e1, 1))", "0" },
	{ "join(point(e1), point(e2)) ^ point(e2)", "0" },
	{ "project_onto(point(1, 2, 3), plane(e3, 0)) ^ plane(e3, 0)", "0" },
	{ "project_onto(e1 + e2, e13)", "e1" },
	{ "reject_from(e1 + e2, e13)", "e2" },
	{ "reflect_in(point(1, 2, 3), plane(e3, 1)) ^ point(1, 2, -1)", "0" },
	{ "reflect_in(point(1, 2, 3), line(0, e3)) ^ point(-1, -2, 3)", "0" },
	{ "reflect_in(point(1, 2, 3), flat_point(0, 0, 0)) ^ point(-1, -2, -3)", "0" },
	{ "point(5, 2, 3) ^ line(point(0, 2, 3), e1)", "0" },

	{ "translator(e1 + 2 e2)", "1 - 0.5 * (e1 + 2 e2) * einf" },
	{ "translator(1, 2, 3)", "translator(vector(1, 2, 3))" },
	{ "rotor(2 e3, deg(90))", "cos(pi / 4) - sin(pi / 4) * e12" },
	{ "sandwich(rotor(e3, deg(90)), e1)", "e2" },
	{ "rotor(0, 0, 2, 2)", "rotor(e3, deg(90))" },
	{ "rotor(1, 0, 0, 0)", "rotor(e1, pi)" },
	{ "dilator(2)", "cosh(log(2) / 2) - sinh(log(2) / 2) * E" },
	{ "motor(e1, rotor(e3, 1))", "translator(e1) * rotor(e3, 1)" },
	{ "motor(e1, -3 rotor(e3, 1), 2)", "-translator(e1) * rotor(e3, 1) * dilator(2)" },
	{ "motor_from(vector(1, 2, 3), 1, 2)", "translator(1, 2, 3) * dilator(2)" },
	{ "exp(-0.5 * pi / 2 * e12)", "rotor(e3, deg(90))" },
	{ "exp(-0.5 * e1 * einf)", "translator(e1)" },
	{ "log(rotor(e3, 1))", "-0.5 e12" },
	{ "log(translator(1, 2, 3))", "-0.5 * vector(1, 2, 3) * einf" },
	{ "sqrt(rotor(e1, 1))", "rotor(e1, 0.5)" },
	{ "power(translator(1, 2, 3), 2)", "translator(2, 4, 6)" },
	{ "sandwich(translator(1, 2, 3), eo)", "vector(1, 2, 3) + 7 einf + eo" },
	{ "sandwich(e1, e1 + e2)", "-e1 + e2" },
	{ "transform_point(motor(e1, rotor(e3, deg(90)), 2), e1)", "e1 + 2 e2" },
	{ "transform_point(translator(e1), eo)", "e1" },
	{ "get_translation(5 motor(e1 + e2, rotor(e3, 1), 2))", "e1 + e2" },
	{ "get_rotation(motor(e1, rotor(e3, 1), 2))", "rotor(e3, 1)" },
	{ "get_scale(-3 motor(e1, rotor(e3, 1), 2))", "2" },

	{ "interpolate_linear(1, translator(1, 2, 3), 0.5)", "translator(0.5, 1, 1.5)" },
	{ "interpolate_screw(dilator(0.5), dilator(2), 0.5)", "1" },
	{ "interpolate_separate(dilator(0.5), dilator(2), 0.5)", "dilator(1.25)" },
};

// Arguments of an accepted kind whose values the function refuses.
const std::vector<std::pair<std::string, std::string>> REFUSED = {
	{ "asin(1.1)", "asin: expected a number in -1..1, not 1.1" },
	{ "acos(-2)", "acos: expected a number in -1..1, not -2" },
	{ "sqrt(-1)", "sqrt: expected a number of at least 0, not -1" },
	{ "log(0)", "log: expected a number above 0, not 0" },
	{ "log(-1)", "log: expected a number above 0, not -1" },
	{ "power(0, -1)", "power: zero has no negative powers" },
	{ "power(-2, 0.5)", "power: a negative number has integer powers only, not 0.5" },
	{ "clamp(1, 2, 0)", "clamp: the minimum 2 is above the maximum 0; swap them" },
	{ "basis_blade(32)", "basis_blade: the index of a basis blade must be an integer in 0..31, not 32" },
	{ "grade(1, 6)", "grade: the grade must be an integer in 0..5, not 6" },
	{ "grade(1, -1)", "grade: the grade must be an integer in 0..5, not -1" },
	{ "rotor(0, 1)", "rotor: the axis is zero; pass a vector of any other length" },
	{ "rotor(0, 0, 0, 0)", "rotor: the quaternion is zero; use (0, 0, 0, 1) for no rotation" },
	{ "dilator(0)", "dilator: the scale must be above 0, not 0" },
	{ "motor(e1, 1, -2)", "motor: the scale must be above 0, not -2" },
	{ "point_pair(e1, e1)", "point_pair: two of the points coincide; pass distinct points" },
	{ "line_through(e1, e1)", "line_through: two of the points coincide; pass distinct points" },
	{ "line(e1, 0)", "line: the direction or normal is zero; pass a vector of any other length" },
	{ "circle(0, e3, 0)", "circle: the radius must be a finite number above zero" },
	{ "circle(0, 0, 1)", "circle: the direction or normal is zero; pass a vector of any other length" },
	{ "circle_through(e1, e2, e1)", "circle_through: two of the points coincide; pass distinct points" },
	{ "plane(0, 1)", "plane: the direction or normal is zero; pass a vector of any other length" },
	{ "plane_through(0, e1, 3 e1)", "plane_through: the points are collinear, so they define no single plane; pass the corners of a triangle" },
	{ "plane_through(0, e1, 0)", "plane_through: the points are collinear, so they define no single plane; pass the corners of a triangle" },
	{ "sphere(0, -1)", "sphere: the radius must be a finite number above zero" },
	{ "sphere_through(e1, e2, -e1, -e2)", "sphere_through: the points lie on one circle or line, so they define no single sphere; pass four that do not" },
	{ "sphere_through(e1, e2, e3, e1)", "sphere_through: two of the points coincide; pass distinct points" },
	{ "meet(1 + e1, e2)", "meet: the first multivector is not a blade (a nonzero outer product of vectors), so it represents no object" },
	{ "join(e12 + e34, e2)", "join: the first multivector is not a blade (a nonzero outer product of vectors), so it represents no object" },
	{ "join(0, e2)", "join: the first multivector is not a blade (a nonzero outer product of vectors), so it represents no object" },
	{ "reflect_in(e1, einf)", "reflect_in: the second multivector is null (a point, a tangent or a direction), so it has no inverse to project or reflect with" },
	{ "sandwich(1 + e1, e2)", "sandwich: expected a versor (a product of non-null vectors)" },
	{ "sandwich(einf, e2)", "sandwich: expected a versor (a product of non-null vectors)" },
	{ "get_scale(e1)", "get_scale: expected a motor (a product of translators, rotors and dilators)" },
	{ "transform_point(0, e1)", "transform_point: expected a motor (a product of translators, rotors and dilators)" },
};

// The called functions with their numbers of arguments: "sphere/2".
std::set<std::string> called_names(const std::string &expression) {
	const cga::TextResult<Expression> parsed = parse(expression);
	REQUIRE_MESSAGE(parsed.has_value(), expression);
	std::set<std::string> names;
	for (const Node &node : parsed->nodes()) {
		if (node.kind == NodeKind::CALL) {
			names.insert(std::string(functions()[node.index].name) + "/" + std::to_string(node.arguments));
		}
	}
	return names;
}

} // namespace

TEST_CASE("each function has its documented value") {
	for (const Case &each : CASES) {
		CAPTURE(each.expression);
		const cga::TextResult<Multivector> value = evaluate(each.expression);
		REQUIRE_MESSAGE(value.has_value(), value.error().describe());
		const Multivector expected = *evaluate(each.expected);
		CHECK_MESSAGE(value->is_equal_approx(expected, 1e-14 * std::max(1.0, expected.max_abs())), cga::to_text(*value), " is not ", cga::to_text(expected));
	}
}

TEST_CASE("a function explains why it refuses an argument") {
	for (const auto &each : REFUSED) {
		const auto &expression = each.first;
		CAPTURE(expression);
		const cga::TextResult<Multivector> value = evaluate(expression);
		REQUIRE_FALSE(value.has_value());
		CHECK(value.error().message == each.second);
		CHECK(value.error().column == 1);
	}
}

TEST_CASE("the cases above cover every function and number of arguments") {
	std::set<std::string> tested;
	for (const Case &each : CASES) {
		const std::set<std::string> names = called_names(each.expression);
		tested.insert(names.begin(), names.end());
	}
	size_t overloads = 0;
	for (const Function &function : functions()) {
		for (const Overload *overload : function.overloads) {
			const std::string name = std::string(function.name) + "/" + std::to_string(overload->count);
			CHECK_MESSAGE(tested.count(name) == 1, name);
			++overloads;
		}
	}
	CHECK(overloads > 70);
}

TEST_CASE("the table is sorted and each entry is complete") {
	std::string_view before;
	for (const Function &function : functions()) {
		CHECK(before < function.name);
		before = function.name;
		CHECK(find_function(function.name).has_value());
		for (const Overload *overload : function.overloads) {
			CAPTURE(overload->signature());
			CHECK(overload->name == function.name);
			CHECK(overload->count >= 1);
			CHECK(overload->count <= MAX_ARGUMENTS);
			const size_t commas = size_t(std::count(overload->parameters.begin(), overload->parameters.end(), ','));
			CHECK(commas + 1 == overload->count);
			CHECK_FALSE(overload->meaning.empty());
		}
	}
	CHECK_FALSE(find_function("").has_value());
	CHECK_FALSE(find_function("zzz").has_value());
}

TEST_CASE("is_of_kind allows for rounding") {
	const auto is = [](std::string_view text, ArgumentKind kind) { return is_of_kind(*evaluate(text), kind); };
	CHECK(is("3", ArgumentKind::NUMBER));
	CHECK(is("3 + 1e-13 * e12", ArgumentKind::NUMBER));
	CHECK_FALSE(is("3 + 1e-9 * e12", ArgumentKind::NUMBER));
	CHECK_FALSE(is("e1", ArgumentKind::NUMBER));
	CHECK(is("0", ArgumentKind::NUMBER));
	CHECK(is("0", ArgumentKind::VECTOR));
	CHECK(is("e1 - 2 e3", ArgumentKind::VECTOR));
	CHECK_FALSE(is("e1 + e4", ArgumentKind::VECTOR));
	CHECK(is("e1", ArgumentKind::LOCATION));
	CHECK(is("eo", ArgumentKind::LOCATION));
	CHECK(is("-3 * (1000 e1 + eo + 500000 einf)", ArgumentKind::LOCATION));
	CHECK_FALSE(is("einf", ArgumentKind::LOCATION));
	CHECK_FALSE(is("e1 + einf", ArgumentKind::LOCATION));
	CHECK_FALSE(is("eo - 0.5 einf", ArgumentKind::LOCATION)); // a dual sphere
	CHECK_FALSE(is("1 + eo", ArgumentKind::LOCATION));
	CHECK(is("2 rotor(e1, 3)", ArgumentKind::ROTATION));
	CHECK(is("1", ArgumentKind::ROTATION));
	CHECK_FALSE(is("0", ArgumentKind::ROTATION));
	CHECK_FALSE(is("1 + e45", ArgumentKind::ROTATION));
	CHECK_FALSE(is("1 + e1", ArgumentKind::ROTATION));
	CHECK(is("-2 motor(e1, rotor(e2, 3), 4)", ArgumentKind::MOTOR));
	CHECK(is("5", ArgumentKind::MOTOR));
	CHECK(is("translator(e1) + 1e-13 * e1", ArgumentKind::MOTOR));
	CHECK_FALSE(is("0", ArgumentKind::MOTOR));
	CHECK_FALSE(is("e1", ArgumentKind::MOTOR));
	CHECK_FALSE(is("E", ArgumentKind::MOTOR)); // scales by -1
	CHECK_FALSE(is("translator(e1) + e23", ArgumentKind::MOTOR));
	CHECK_FALSE(is("einf ^ e1", ArgumentKind::MOTOR));
}
