#pragma once

#include "playground/document/entry.hpp"

#include <vector>

namespace playground {

// Computes `entries` anew, and of what depends on them only what can have changed: entries of which a dependency has another
// value or error than before. Returns those whose value or error changed, dependencies first.
//
// What is wrong stays with its entry: a text that is no expression, a name that is none, a cycle, a function without result.
// An entry that depends on a broken one says which.
std::vector<Entry *> reevaluate(const std::vector<Entry *> &entries, const EntryIndex &index);

} // namespace playground
