#pragma once

#include <string>
#include <string_view>

namespace playground {

// Converts pasted text to an expression: a ganja.js element as JSON.stringify writes it, an object with the keys "0".."31"
// or "coefficients", becomes a list of 32 numbers. Any other text is returned as it is.
[[nodiscard]] std::string pasted_expression(std::string_view text);

} // namespace playground
