#pragma once

#include "playground/document/literal.hpp"

#include <string>
#include <string_view>
#include <vector>

// Free objects: expressions that call a constructor with literals, whose parameters a person can drag.

namespace playground {

struct Parameter {
	std::string name;
	Literal literal;
};

// What can be changed in an expression without changing what it is. By expression:
//
//   2.5                                value: a number
//   [32 numbers], 1 + 2 e12            coefficients: a multivector
//   point(1, 2, 3)                     position: a vector
//   sphere(e1, 2)                      center, radius; and so on: the names of functions.hpp
//   point_pair(e1, point(1, 2, 3))     a, b
//   motor(e1, rotor(e3, deg(90)), 1)   translation, axis, angle, rotation (a quaternion), scale
//
// Also where it is dualised, negated, reversed or in brackets: !sphere(e1, 2). Arguments that are computed have no
// parameter: sphere(a, 2) has its radius. None of what is no such expression.
[[nodiscard]] std::vector<Parameter> parameters_of(std::string_view text);

// One of what a constructor is called with, by the name that functions.hpp has for it.
struct Argument {
	std::string_view name;
	std::string_view text; // of its expression
};

// Of such an expression all arguments, also those that are computed. Views into the text.
[[nodiscard]] std::vector<Argument> arguments_of(std::string_view text);

struct Rewritten {
	std::string error; // why it cannot be, as a sentence
	std::string text;
};

// The text with a parameter of another value. All else, spaces included, stays.
[[nodiscard]] Rewritten with_parameter(std::string_view text, std::string_view name, const LiteralValue &value);

} // namespace playground
