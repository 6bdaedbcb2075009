#include "playground/expression/function_table.hpp"

#include "cga/text/readable.hpp"

#include <algorithm>
#include <cmath>

namespace playground {

namespace {

constexpr double RADIANS_PER_DEGREE = 3.14159265358979323846 / 180.0;

// Wraps a standard library function of one number.
template <double (*FUNCTION)(double)>
FunctionResult of_number(const Arguments &arguments) {
	return number(FUNCTION(arguments.number(0)));
}

template <size_t COUNT, bool IS_LESS>
FunctionResult extreme(const Arguments &arguments) {
	double result = arguments.number(0);
	for (size_t index = 1; index < COUNT; ++index) {
		result = IS_LESS ? std::min(result, arguments.number(index)) : std::max(result, arguments.number(index));
	}
	return number(result);
}

FunctionResult inverse_trigonometric(double (*function)(double), double value) {
	if (!(std::abs(value) <= 1.0)) {
		return Error("expected a number in -1..1, not " + cga::readable(value));
	}
	return number(function(value));
}

FunctionResult square_root(const Arguments &arguments) {
	if (arguments.number(0) < 0.0) {
		return Error("expected a number of at least 0, not " + cga::readable(arguments.number(0)));
	}
	return number(std::sqrt(arguments.number(0)));
}

FunctionResult logarithm(const Arguments &arguments) {
	if (!(arguments.number(0) > 0.0)) {
		return Error("expected a number above 0, not " + cga::readable(arguments.number(0)));
	}
	return number(std::log(arguments.number(0)));
}

FunctionResult power(const Arguments &arguments) {
	const double base = arguments.number(0);
	const double exponent = arguments.number(1);
	if (base == 0.0 && exponent < 0.0) {
		return Error("zero has no negative powers");
	}
	if (base < 0.0 && exponent != std::floor(exponent)) {
		return Error("a negative number has integer powers only, not " + cga::readable(exponent));
	}
	return number(std::pow(base, exponent));
}

FunctionResult clamp(const Arguments &arguments) {
	if (arguments.number(1) > arguments.number(2)) {
		return Error("the minimum " + cga::readable(arguments.number(1)) + " is above the maximum " + cga::readable(arguments.number(2)) + "; swap them");
	}
	return number(std::clamp(arguments.number(0), arguments.number(1), arguments.number(2)));
}

double sign(double value) {
	return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0);
}

double radians(double degrees) {
	return degrees * RADIANS_PER_DEGREE;
}

double degrees(double radians) {
	return radians / RADIANS_PER_DEGREE;
}

// These come before the versor functions of the same name: a number is also a versor.
constexpr Overload TABLE[] = {
	{ "sin", "angle", 1, { N }, of_number<std::sin>, "sine of an angle in radians" },
	{ "cos", "angle", 1, { N }, of_number<std::cos>, "cosine of an angle in radians" },
	{ "tan", "angle", 1, { N }, of_number<std::tan>, "tangent of an angle in radians" },
	{ "asin", "x", 1, { N }, [](const Arguments &a) { return inverse_trigonometric(std::asin, a.number(0)); }, "angle -pi/2..pi/2 whose sine is x" },
	{ "acos", "x", 1, { N }, [](const Arguments &a) { return inverse_trigonometric(std::acos, a.number(0)); }, "angle 0..pi whose cosine is x" },
	{ "atan", "x", 1, { N }, of_number<std::atan>, "angle -pi/2..pi/2 whose tangent is x" },
	{ "atan2", "y, x", 2, { N, N }, [](const Arguments &a) { return number(std::atan2(a.number(0), a.number(1))); }, "angle -pi..pi of the direction (x, y)" },
	{ "sinh", "x", 1, { N }, of_number<std::sinh>, "hyperbolic sine" },
	{ "cosh", "x", 1, { N }, of_number<std::cosh>, "hyperbolic cosine" },
	{ "tanh", "x", 1, { N }, of_number<std::tanh>, "hyperbolic tangent" },
	{ "exp", "x", 1, { N }, of_number<std::exp>, "e to the power of x" },
	{ "log", "x", 1, { N }, logarithm, "natural logarithm of a number above 0" },
	{ "sqrt", "x", 1, { N }, square_root, "square root of a non-negative number" },
	{ "power", "x, exponent", 2, { N, N }, power, "x to the power of the exponent" },
	{ "abs", "x", 1, { N }, of_number<std::fabs>, "absolute value" },
	{ "sign", "x", 1, { N }, of_number<sign>, "-1, 0 or 1" },
	{ "floor", "x", 1, { N }, of_number<std::floor>, "the largest integer not above x" },
	{ "ceil", "x", 1, { N }, of_number<std::ceil>, "the smallest integer not below x" },
	{ "round", "x", 1, { N }, of_number<std::round>, "the nearest integer" },
	{ "min", "a, b", 2, { N, N }, extreme<2, true>, "the smallest of its arguments" },
	{ "min", "a, b, c", 3, { N, N, N }, extreme<3, true>, "the smallest of its arguments" },
	{ "min", "a, b, c, d", 4, { N, N, N, N }, extreme<4, true>, "the smallest of its arguments" },
	{ "max", "a, b", 2, { N, N }, extreme<2, false>, "the largest of its arguments" },
	{ "max", "a, b, c", 3, { N, N, N }, extreme<3, false>, "the largest of its arguments" },
	{ "max", "a, b, c, d", 4, { N, N, N, N }, extreme<4, false>, "the largest of its arguments" },
	{ "clamp", "x, minimum, maximum", 3, { N, N, N }, clamp, "x, limited to minimum..maximum" },
	{ "deg_to_rad", "degrees", 1, { N }, of_number<radians>, "an angle in radians" },
	{ "rad_to_deg", "radians", 1, { N }, of_number<degrees>, "an angle in degrees" },
	{ "deg", "degrees", 1, { N }, of_number<radians>, "an angle in radians, as deg_to_rad: deg(90)" },
};

} // namespace

FunctionTable number_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
