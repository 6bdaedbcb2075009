#pragma once

#include "cga/vector.hpp"

#include <string>

// Numbers for people to read: six digits, not what a reader needs to get the same number back.

namespace cga {

[[nodiscard]] std::string readable(double value);
// "(0, 1, 0.5)". Components that beside the largest of them, or beside `size`, are rounding are 0.
[[nodiscard]] std::string readable(const Vector3<double> &vector, double size = 0.0);

} // namespace cga
