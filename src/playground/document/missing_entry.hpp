#pragma once

#include "playground/document/entry.hpp"

#include <string>

namespace playground {

// What to say where an expression refers to a name that no entry has, and which was probably meant.
[[nodiscard]] std::string missing_entry(const std::string &name, const EntryIndex &index);

} // namespace playground
