#pragma once

#include "playground/expression/functions.hpp"

// The parts of the table that functions() puts together, one source file for each subject.

namespace playground {

struct FunctionTable {
	const Overload *first;
	size_t count;
};

// Numbers from numbers: sin, min, deg_to_rad, ...
[[nodiscard]] FunctionTable number_functions();
// Between two motors.
[[nodiscard]] FunctionTable interpolation_functions();
// Points, lines, circles, planes, spheres, and what they have to do with each other.
[[nodiscard]] FunctionTable object_functions();
// Products, parts, conjugations, norms.
[[nodiscard]] FunctionTable product_functions();
// Translators, rotors, dilators, motors; exp, log and powers; what a motor does.
[[nodiscard]] FunctionTable versor_functions();

// What the tables are written with.

inline constexpr ArgumentKind X = ArgumentKind::ANY;
inline constexpr ArgumentKind N = ArgumentKind::NUMBER;
inline constexpr ArgumentKind V = ArgumentKind::VECTOR;
inline constexpr ArgumentKind P = ArgumentKind::LOCATION;
inline constexpr ArgumentKind R = ArgumentKind::ROTATION;
inline constexpr ArgumentKind M = ArgumentKind::MOTOR;

using Outcome = cga::Result<cga::Multivector>;

[[nodiscard]] inline Outcome number(double value) {
	return cga::Multivector::scalar(value);
}

[[nodiscard]] inline Outcome truth(bool value) {
	return number(value ? 1.0 : 0.0);
}

} // namespace playground
