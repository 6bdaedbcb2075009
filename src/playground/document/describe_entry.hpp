#pragma once

#include "playground/document/entry.hpp"

#include <string>

namespace playground {

// Describes the value of an entry in one line: "circle, radius 1.5, center (0, 1, 0), normal (0, 0, 1)", "number 2.5",
// "motor, translation (1, 0, 0), 90 degrees about (0, 0, 1), scale 2". The attribute "ipns" selects the dual object. An
// entry with an error gives "error: column 3: ...".
[[nodiscard]] std::string describe(const Entry &entry);

} // namespace playground
