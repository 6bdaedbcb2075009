#pragma once

#include <string>
#include <string_view>

namespace playground {

// As Expression::renamed, of a text that is no expression (yet): wherever the name stands, but for where a function is
// called, up to the first character that is not of the language.
[[nodiscard]] std::string with_variable_renamed(std::string_view text, std::string_view from, std::string_view to);

} // namespace playground
