#pragma once

#include <string>
#include <string_view>

namespace playground {

// The expression that is meant by a text from elsewhere: what JSON.stringify makes of a ganja.js element, an object with
// keys "0".."31" or "coefficients", becomes the list of its 32 numbers. All else stays as it is.
[[nodiscard]] std::string pasted_expression(std::string_view text);

} // namespace playground
