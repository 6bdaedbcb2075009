#pragma once

#include <string>
#include <string_view>

namespace playground {

// Expression::renamed for a text that does not parse: renames every occurrence except calls, up to the first invalid
// token.
[[nodiscard]] std::string with_variable_renamed(std::string_view text, std::string_view from, std::string_view to);

} // namespace playground
