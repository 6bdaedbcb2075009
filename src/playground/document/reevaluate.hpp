#pragma once

#include "playground/document/entry.hpp"

#include <vector>

namespace playground {

// Recomputes `entries` and those of their dependents that can have changed: a dependency has a new value or error. Returns
// the entries whose value or error changed, dependencies first.
//
// An entry with an error does not stop the others; the error of an entry that depends on it names it.
std::vector<Entry *> reevaluate(const std::vector<Entry *> &entries, const EntryIndex &index);

} // namespace playground
