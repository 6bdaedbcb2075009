#pragma once

#include "playground/document/literal.hpp"
#include "playground/expression/error.hpp"

#include <string>
#include <string_view>
#include <vector>

// Free objects: expressions that call a constructor with literals, whose parameters can be dragged.

namespace playground {

struct Parameter {
	std::string name;
	Literal literal;
};

// Returns the parameters of an expression: the literals that can be replaced without changing its structure. Examples:
//
//   2.5                                value: a number
//   [32 numbers], 1 + 2 e12            coefficients: a multivector
//   point(1, 2, 3)                     position: a vector
//   sphere(e1, 2)                      center, radius; and so on, named as in functions.hpp
//   point_pair(e1, point(1, 2, 3))     a, b
//   motor(e1, rotor(e3, deg(90)), 1)   translation, axis, angle, rotation (a quaternion), scale
//
// A dual, sign, reverse, normalization or parentheses around the call are ignored: !sphere(e1, 2). Computed arguments are
// not parameters: sphere(a, 2) has only its radius. Empty for all other expressions.
[[nodiscard]] std::vector<Parameter> parameters_of(std::string_view text);

// An argument of a constructor, named as in functions.hpp.
struct Argument {
	std::string_view name;
	std::string_view text; // its expression
};

// All arguments of a constructor, including computed ones; empty for all other expressions. Views into `text`.
[[nodiscard]] std::vector<Argument> arguments_of(std::string_view text);

// The text with a new value of a parameter. Everything else, including spaces, is unchanged. An unknown parameter, a value
// of another type and a value that is not finite are errors.
cga::Result<std::string, Error> with_parameter(std::string_view text, std::string_view name, const LiteralValue &value);

} // namespace playground
