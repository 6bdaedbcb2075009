#pragma once

#include <string>

namespace playground {

// A number as a person would type it. One that ten digits say exactly is written so: it was typed, or came in steps. Others
// come from dragging, often by way of single precision, and are rounded to the seventh digit of `size`, the largest of the
// numbers that it stands beside: 1.2000000476837158 is "1.2", and 1e-9 beside 1 is "0".
[[nodiscard]] std::string number_text(double value, double size);

} // namespace playground
