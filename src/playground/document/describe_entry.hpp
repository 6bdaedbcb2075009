#pragma once

#include "playground/document/entry.hpp"

#include <string>

namespace playground {

// What an entry's value is, in one line for people: "circle, radius 1.5, center (0, 1, 0), normal (0, 0, 1)", "number 2.5",
// "motor, by (1, 0, 0), 90 degrees about (0, 0, 1), scale 2". By its attribute "ipns" as a dual object. Of an entry with an
// error "error: column 3: ...".
[[nodiscard]] std::string describe(const Entry &entry);

} // namespace playground
