#pragma once

#include "playground/document/entry_index.hpp"

#include <string>
#include <vector>

namespace playground {

// Recomputes `entries`, and those of their dependents that have a dependency with a new value or error. Returns the entries
// whose value or error changed, dependencies first.
//
// An error in one entry does not stop the evaluation of the others; the errors of its dependents name it.
std::vector<Entry *> reevaluate(const std::vector<Entry *> &entries, const EntryIndex &index);

// The error message for a reference to a name that has no entry, with a suggestion if a similar name exists among
// at most MAX_CANDIDATES.
[[nodiscard]] std::string missing_entry(const std::string &name, const EntryIndex &index);

} // namespace playground
