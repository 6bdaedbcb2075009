#pragma once

#include "playground/document/entry.hpp"

#include <vector>

// The dependency graph of the entries. Traversals use an explicit stack, so that long chains are safe.

namespace playground {

// Replaces the dependencies of the entry by the entries its expression refers to, and registers it as their dependent.
void connect(Entry &entry, const EntryIndex &index);
// Clears the dependencies of the entry and removes it from their dependents.
void disconnect(Entry &entry);

// `entries` and all entries that depend on them, each once.
[[nodiscard]] std::vector<Entry *> with_dependents(const std::vector<Entry *> &entries);

// A strongly connected component: entries in a cycle, or a single entry.
struct Component {
	std::vector<Entry *> members;
	bool is_cycle = false;
};

// The components in topological order: each after those it depends on. Dependencies outside `entries` are ignored.
// (Tarjan, Depth-first search and linear graph algorithms, 1972.)
[[nodiscard]] std::vector<Component> components_in_evaluation_order(const std::vector<Entry *> &entries);

// The shortest path from an entry of a cycle back to itself: a, b, c for a -> b -> c -> a.
[[nodiscard]] std::vector<const Entry *> shortest_cycle(const Entry &entry, const Component &component);

} // namespace playground
