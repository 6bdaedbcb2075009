#include "playground/document/parameters.hpp"

#include "playground/expression/evaluate.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace playground;

namespace {

using Vector = cga::Vector3<double>;
using Rotation = cga::Quaternion<double>;

// The names in order: "center radius".
std::string names_of(const char *text) {
	std::string names;
	for (const Parameter &parameter : parameters_of(text)) {
		names += (names.empty() ? "" : " ") + parameter.name;
	}
	return names;
}

template <class T>
T value_of(const char *text, const char *name) {
	for (const Parameter &parameter : parameters_of(text)) {
		if (parameter.name == name) {
			REQUIRE(std::get_if<T>(&parameter.literal.value));
			return *std::get_if<T>(&parameter.literal.value);
		}
	}
	FAIL(text, " has no ", name);
	return T();
}

std::string changed(const char *text, const char *name, const LiteralValue &value) {
	const cga::Result<std::string, Error> result = with_parameter(text, name, value);
	return result ? *result : "error: " + result.error().message;
}

} // namespace

TEST_CASE("the parameters of each constructor") {
	CHECK(names_of("2.5") == "value coefficients");
	CHECK(names_of("scalar(2)") == "value");
	CHECK(names_of("vector(1, 2, 3)") == "vector");
	CHECK(names_of("point(1, 2, 3)") == "position");
	CHECK(names_of("point(e1 + 2 e2)") == "position");
	CHECK(names_of("point(vector(1, 2, 3))") == "position");
	CHECK(names_of("flat_point(1, 2, 3)") == "position");
	CHECK(names_of("point_pair(e1, point(1, 2, 3))") == "a b");
	CHECK(names_of("line(e1, e2)") == "point direction");
	CHECK(names_of("line(e1, point(e2))") == "a b");
	CHECK(names_of("line_through(e1, e2)") == "a b");
	CHECK(names_of("circle(e1, e2, 2)") == "center normal radius");
	CHECK(names_of("circle(e1, e2, e3)") == "a b c");
	CHECK(names_of("plane(e3, 1)") == "normal distance");
	CHECK(names_of("plane(0, 0, 1, 2)") == "normal distance");
	CHECK(names_of("plane(e1, e2, e3)") == "a b c");
	CHECK(names_of("sphere(1, 2, 3, 4)") == "center radius");
	CHECK(names_of("sphere(eo, 4)") == "center radius");
	CHECK(names_of("sphere_through(e1, e2, e3, 0)") == "a b c d");
	CHECK(names_of("imaginary_circle(e1, e2, 2)") == "center normal radius");
	CHECK(names_of("tangent_along(e1, e2)") == "point direction");
	CHECK(names_of("direction(e1)") == "vector");
	CHECK(names_of("translator(1, 2, 3)") == "offset");
	CHECK(names_of("translator(e1)") == "offset");
	CHECK(names_of("rotor(0, 0, 0, 1)") == "rotation");
	CHECK(names_of("rotor(e3, deg(90))") == "axis angle rotation");
	CHECK(names_of("dilator(2)") == "scale");
	CHECK(names_of("motor(e1, rotor(e3, 1))") == "translation axis angle rotation");
	CHECK(names_of("motor_from(e1, rotor(0, 0, 0, 1), 2)") == "translation rotation scale");
	CHECK(names_of("motor(e1, 1)") == "translation rotation");
	CHECK(names_of("1 + 2 e12 - 0.5 e13*3") == "coefficients");
}

TEST_CASE("duals, signs and parentheses around a constructor are ignored") {
	CHECK(names_of("!sphere(e1, 2)") == "center radius");
	CHECK(names_of("-(~dual((sphere(e1, 2))))") == "center radius");
	CHECK(changed(" !( sphere(e1, 2) ) ", "radius", 3.0) == " !( sphere(e1, 3) ) ");
}

TEST_CASE("all arguments of a constructor, by name") {
	const std::vector<Argument> arguments = arguments_of("-!circle(a ^ b, 2 e1, 3)");
	REQUIRE(arguments.size() == 3);
	CHECK(arguments[0].name == "center");
	CHECK(arguments[0].text == "a ^ b");
	CHECK(arguments[1].name == "normal");
	CHECK(arguments[1].text == "2 e1");
	CHECK(arguments[2].name == "radius");
	for (const char *text : { "", "a", "meet(a, b)", "sphere(1, 2", "sphere(1)", "2.5", "sin(2)" }) {
		CHECK_MESSAGE(arguments_of(text).empty(), text);
	}
}

TEST_CASE("computed arguments are not parameters") {
	CHECK(names_of("sphere(a, 2)") == "radius");
	CHECK(names_of("sphere(a, r)") == "");
	CHECK(names_of("sphere(2 e1, sqrt(2))") == "center");
	CHECK(names_of("point(1, t, 3)") == "x z");
	CHECK(names_of("a") == "");
	CHECK(names_of("2 a") == "");
	CHECK(names_of("point(1, 2, 3) ^ einf") == "");
	CHECK(names_of("(point(1, 2, 3)) + (point(1, 2, 3))") == "");
	CHECK(names_of("meet(e1, e2)") == "");
	CHECK(names_of("pi") == "");
	CHECK(names_of("point(1, 2") == "");
	CHECK(names_of("point(1, 2)") == "");
	CHECK(names_of("") == "");
}

TEST_CASE("values of parameters") {
	CHECK(value_of<double>("- -+2.5", "value") == 2.5);
	CHECK(value_of<Vector>("point(1, -2, 3e-7)", "position") == Vector(1.0, -2.0, 3e-7));
	CHECK(value_of<Vector>("sphere(2 e1 - e3*0.5, 1)", "center") == Vector(2.0, 0.0, -0.5));
	CHECK(value_of<Vector>("sphere(0, 1)", "center") == Vector(0.0));
	CHECK(value_of<double>("rotor(e3, deg(180))", "angle") == doctest::Approx(3.141592653589793));
	const Rotation rotation = value_of<Rotation>("rotor(2 e3, deg(90))", "rotation");
	CHECK(rotation.w == doctest::Approx(0.7071067811865476));
	CHECK(rotation.z == doctest::Approx(0.7071067811865476));
	CHECK(value_of<Rotation>("rotor(1, 2, 3, 4)", "rotation") == Rotation(4.0, 1.0, 2.0, 3.0));
	CHECK(value_of<cga::Multivector>("1 - 2 e12", "coefficients")[6] == -2.0);
}

TEST_CASE("a new value rewrites only the literal") {
	CHECK(changed("2", "value", -3.25) == "-3.25");
	CHECK(changed("point( 1.0 , 2, -3 )", "position", Vector(1.0, 2.5, 3.0)) == "point( 1.0 , 2.5, 3 )");
	CHECK(changed("point(1, 2, 3)", "position", Vector(float(1.2f), 0.0, -1e-9)) == "point(1.2, 0, -1e-09)");
	CHECK(changed("point(e1)", "position", Vector(1.0, -0.5, 0.0)) == "point(e1 - 0.5 e2)");
	CHECK(changed("point(e1)", "position", Vector(0.0)) == "point(0)");
	CHECK(changed("sphere(point(1, 2, 3), 4)", "center", Vector(1.0, 2.0, 4.0)) == "sphere(point(1, 2, 4), 4)");
	CHECK(changed("sphere(eo, 4)", "center", Vector(1.0, 0.0, 0.0)) == "sphere(e1, 4)");
	CHECK(changed("point(1, t, 3)", "z", 5.0) == "point(1, t, 5)");
	CHECK(changed("rotor(e3, deg( 90 ))", "angle", 0.5235987755982988) == "rotor(e3, deg( 30 ))");
	CHECK(changed("rotor(e3, 1)", "angle", 0.5) == "rotor(e3, 0.5)");
	CHECK(changed("rotor(0, 0, 0, 1)", "rotation", Rotation(0.5, 0.5, 0.5, 0.5)) == "rotor(0.5, 0.5, 0.5, 0.5)");
	CHECK(changed("motor(e1, 1)", "rotation", Rotation(0.5, 0.5, 0.5, 0.5)) == "motor(e1, rotor(0.5, 0.5, 0.5, 0.5))");
	CHECK(changed("1 + 2 e12", "coefficients", cga::Multivector::basis_blade(6, 3.5)) == "3.5 e12");
}

TEST_CASE("a new rotation rewrites axis and angle") {
	const double half = 0.7071067811865476;
	CHECK(changed("rotor(e3, deg(10))", "rotation", Rotation(half, 0.0, 0.0, half)) == "rotor(e3, deg(90))");
	CHECK(changed("rotor(e3, deg(10))", "rotation", Rotation(half, 0.0, 0.0, -half)) == "rotor(e3, deg(-90))");
	CHECK(changed("rotor(2 e3, deg(10))", "rotation", Rotation(-half, 0.0, 0.0, -half)) == "rotor(2 e3, deg(90))");
	CHECK(changed("rotor(e3, deg(10))", "rotation", Rotation(1.0, 0.0, 0.0, 0.0)) == "rotor(e3, deg(0))");
	CHECK(changed("motor(0, rotor(e3, deg(10)))", "rotation", Rotation(half, half, 0.0, 0.0)) == "motor(0, rotor(e1, deg(90)))");
}

TEST_CASE("only the coefficients that differ are rewritten in a list") {
	std::string list = "[ 0";
	std::string expected = "[ 0";
	for (int index = 1; index < 32; ++index) {
		list += ",\n1.0";
		expected += index == 7 ? ",\n-0.1" : ",\n1.0";
	}
	cga::Multivector value = *evaluate(list + "]");
	value[7] = -0.1;
	CHECK(changed((list + "]").c_str(), "coefficients", value) == expected + "]");
	CHECK(changed(("~" + list + "]").c_str(), "coefficients", value) == "~" + expected + "]");
}

TEST_CASE("unknown parameters, values of other types and values that are not finite are refused") {
	CHECK(changed("sphere(e1, 2)", "center", 1.0) == "error: the parameter 'center' must be a vector, not a number");
	CHECK(changed("sphere(e1, 2)", "size", 1.0) == "error: the expression has no parameter 'size'; it has center, radius");
	CHECK(changed("a", "size", 1.0) == "error: the expression has no parameter 'size'; only literals of constructors can be set: write a number or a call such as point(1, 2, 3)");
	CHECK(changed("sphere(e1, 2)", "radius", std::numeric_limits<double>::infinity()) == "error: the parameter 'radius' must be finite");
}

TEST_CASE("setting a parameter to its current value leaves the text unchanged") {
	for (const char *text : { "2.50", "point(1.0, 2, 3)", "sphere( e2*2, 01.5)", "rotor(e3, deg(33.3))", "rotor(e3, deg(111111111111111133.3))", "motor(2 e1, rotor(e1 + e2, 0.3), 2)", "plane(1, 2, 3, 4)", "1 + 2 e12 - e3", "pair(0, e1)" }) {
		for (const Parameter &parameter : parameters_of(text)) {
			CHECK_MESSAGE(changed(text, parameter.name.c_str(), parameter.literal.value) == text, text, " ", parameter.name);
		}
	}
}
