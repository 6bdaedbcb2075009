#pragma once

#include "playground/document/entry.hpp"

#include <string>

namespace playground {

// The error message for a reference to a name that has no entry, with a suggestion if a similar name exists.
[[nodiscard]] std::string missing_entry(const std::string &name, const EntryIndex &index);

} // namespace playground
