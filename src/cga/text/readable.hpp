#pragma once

#include "cga/vector.hpp"

#include <string>

// Numbers for display, with six significant digits: reading them back loses precision.

namespace cga {

[[nodiscard]] std::string readable(double value);
// "(0, 1, 0.5)". Components below 1e-12 of the largest, or of `size` if that is larger, are written as 0.
[[nodiscard]] std::string readable(const Vector3<double> &vector, double size = 0.0);

} // namespace cga
