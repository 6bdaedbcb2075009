#pragma once

#include "playground/expression/functions.hpp"

// The tables that functions() merges, one source file per subject.

namespace playground {

struct FunctionTable {
	const Overload *first;
	size_t count;
};

// Functions of numbers with a number as result: sin, min, deg_to_rad, ...
[[nodiscard]] FunctionTable number_functions();
// Geometric objects and operations on them.
[[nodiscard]] FunctionTable object_functions();
// Products, grades, conjugations, norms.
[[nodiscard]] FunctionTable product_functions();
// Translators, rotors, dilators, motors; exp, log and powers; applying, decomposing and interpolating motors.
[[nodiscard]] FunctionTable versor_functions();

// Abbreviations for the tables.

inline constexpr ArgumentKind X = ArgumentKind::ANY;
inline constexpr ArgumentKind N = ArgumentKind::NUMBER;
inline constexpr ArgumentKind V = ArgumentKind::VECTOR;
inline constexpr ArgumentKind P = ArgumentKind::LOCATION;
inline constexpr ArgumentKind R = ArgumentKind::ROTATION;
inline constexpr ArgumentKind M = ArgumentKind::MOTOR;

[[nodiscard]] inline FunctionResult number(double value) {
	return cga::Multivector::scalar(value);
}

[[nodiscard]] inline FunctionResult truth(bool value) {
	return number(value ? 1.0 : 0.0);
}

} // namespace playground
