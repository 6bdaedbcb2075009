#include "playground/expression/function_table.hpp"

#include <algorithm>
#include <cmath>

namespace playground {

namespace {

using cga::Failure;

constexpr double RADIANS_PER_DEGREE = 3.14159265358979323846 / 180.0;

// A function of the standard library of one number.
template <double (*function)(double)>
Outcome of_number(const Arguments &arguments) {
	return number(function(arguments.number(0)));
}

template <size_t count, bool is_less>
Outcome extreme(const Arguments &arguments) {
	double result = arguments.number(0);
	for (size_t index = 1; index < count; ++index) {
		result = is_less ? std::min(result, arguments.number(index)) : std::max(result, arguments.number(index));
	}
	return number(result);
}

Outcome inverse_trigonometric(double (*function)(double), double value) {
	if (!(std::abs(value) <= 1.0)) {
		return Failure{ "The number must lie between -1 and 1" };
	}
	return number(function(value));
}

Outcome square_root(const Arguments &arguments) {
	if (arguments.number(0) < 0.0) {
		return Failure{ "A negative number has no square root" };
	}
	return number(std::sqrt(arguments.number(0)));
}

Outcome logarithm(const Arguments &arguments) {
	if (!(arguments.number(0) > 0.0)) {
		return Failure{ "Only numbers above 0 have a logarithm" };
	}
	return number(std::log(arguments.number(0)));
}

Outcome power(const Arguments &arguments) {
	const double base = arguments.number(0);
	const double exponent = arguments.number(1);
	if (base == 0.0 && exponent < 0.0) {
		return Failure{ "Zero has no negative powers" };
	}
	if (base < 0.0 && exponent != std::floor(exponent)) {
		return Failure{ "A negative number has whole powers only" };
	}
	return number(std::pow(base, exponent));
}

Outcome clamp(const Arguments &arguments) {
	if (arguments.number(1) > arguments.number(2)) {
		return Failure{ "The minimum is above the maximum; exchange them" };
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

// Functions of numbers stand before those of versors with the same name, which numbers are as well.
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
	{ "sqrt", "x", 1, { N }, square_root, "square root of a number that is not negative" },
	{ "power", "x, exponent", 2, { N, N }, power, "x to the power of the exponent" },
	{ "abs", "x", 1, { N }, of_number<std::fabs>, "absolute value" },
	{ "sign", "x", 1, { N }, of_number<sign>, "-1, 0 or 1" },
	{ "floor", "x", 1, { N }, of_number<std::floor>, "the next whole number downwards" },
	{ "ceil", "x", 1, { N }, of_number<std::ceil>, "the next whole number upwards" },
	{ "round", "x", 1, { N }, of_number<std::round>, "the nearest whole number" },
	{ "min", "a, b", 2, { N, N }, extreme<2, true>, "the smallest of the numbers" },
	{ "min", "a, b, c", 3, { N, N, N }, extreme<3, true>, "the smallest of the numbers" },
	{ "min", "a, b, c, d", 4, { N, N, N, N }, extreme<4, true>, "the smallest of the numbers" },
	{ "max", "a, b", 2, { N, N }, extreme<2, false>, "the largest of the numbers" },
	{ "max", "a, b, c", 3, { N, N, N }, extreme<3, false>, "the largest of the numbers" },
	{ "max", "a, b, c, d", 4, { N, N, N, N }, extreme<4, false>, "the largest of the numbers" },
	{ "clamp", "x, minimum, maximum", 3, { N, N, N }, clamp, "x, moved into minimum..maximum" },
	{ "deg_to_rad", "degrees", 1, { N }, of_number<radians>, "an angle in radians" },
	{ "rad_to_deg", "radians", 1, { N }, of_number<degrees>, "an angle in degrees" },
	{ "deg", "degrees", 1, { N }, of_number<radians>, "the same as deg_to_rad, to be read as a unit: deg(90)" },
};

} // namespace

FunctionTable number_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
