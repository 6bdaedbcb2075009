#pragma once

#include <string>

namespace playground {

// Formats a number as a user would type it. A number of at most ten significant digits is written exactly: it was typed or
// snapped to a step. Other numbers come from dragging, often in single precision, and are rounded to the seventh significant
// digit of `size`, the magnitude of the whole value: 1.2000000476837158 gives "1.2", and 1e-9 beside 1 gives "0".
[[nodiscard]] std::string number_text(double value, double size);

} // namespace playground
