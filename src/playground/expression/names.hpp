#pragma once

#include "cga/algebra/multivector.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Names of the expression language: what they look like, and those that have a fixed value.

namespace playground {

inline constexpr size_t MAX_NAME_LENGTH = 64; // characters

// The bytes of the name that a text begins with; 0 if it begins with none. Of any number of characters.
[[nodiscard]] size_t name_length(std::string_view text);

// The value of a name that is no variable: e1 .. e12345 with digits in any order, eo, einf (also ei), E, I, pi, tau.
[[nodiscard]] std::optional<cga::Multivector> constant(std::string_view name);

// Why a variable cannot have this name, as a sentence; empty if it can. Names are letters (of any script), digits and
// underscores, do not begin with a digit, have at most MAX_NAME_LENGTH characters, are no constant and do not look like
// a basis blade (e and digits). Names of functions are free: only a name before '(' is a function.
[[nodiscard]] std::string name_error(std::string_view name);

// The name among `candidates` that `name` most likely was meant to be: a few typing errors away. Empty if none is.
[[nodiscard]] std::string_view closest_name(std::string_view name, const std::vector<std::string_view> &candidates);

} // namespace playground
