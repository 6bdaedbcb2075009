#pragma once

#include "cga/algebra/multivector.hpp"
#include "playground/expression/error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Names of the expression language: their syntax, and the constants.

namespace playground {

inline constexpr size_t MAX_NAME_LENGTH = 64; // characters

// The length in bytes of the name at the start of a text, 0 if it does not start with a name. Not limited to MAX_NAME_LENGTH.
[[nodiscard]] size_t name_length(std::string_view text);

// The value of a constant: e1 .. e12345 with digits in any order, eo, einf (also ei), E, I, pi, tau.
[[nodiscard]] std::optional<cga::Multivector> constant(std::string_view name);

// Whether a variable may have this name: letters of any script, digits and underscores, no digit first, at most
// MAX_NAME_LENGTH characters; not a constant, and not e followed by digits. A variable may share its name with a
// function, because only a name before '(' is a call.
cga::Result<void, Error> check_name(std::string_view name);

// The candidate closest to a misspelled name; empty if none is close.
[[nodiscard]] std::string_view closest_name(std::string_view name, const std::vector<std::string_view> &candidates);
// The closest name as the end of an error message: "; did you mean 'sphere'?". Empty if none is close.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string_view> &candidates);

} // namespace playground
