#pragma once

#include "playground/document/entry.hpp"

#include <vector>

// The dependency graph of the entries. Traversals use an explicit stack, so that long chains are safe.

namespace playground {

// `entries` and all entries that depend on them, each once.
[[nodiscard]] std::vector<Entry *> with_dependents(const std::vector<Entry *> &entries);

// A strongly connected component: entries in a cycle, or a single entry.
struct Component {
	std::vector<Entry *> members;
	bool is_cycle = false;
};

// The components in topological order: each after those it depends on. Dependencies outside `entries` are ignored. Numbers
// the entries with the indices of their components.
// (Tarjan, Depth-first search and linear graph algorithms, 1972.)
[[nodiscard]] std::vector<Component> components_in_evaluation_order(const std::vector<Entry *> &entries);

// Whether the last call of components_in_evaluation_order() put both into the same component. False for null.
[[nodiscard]] bool is_in_same_component(const Entry &entry, const Entry *other);

// The shortest path from an entry of a cycle back to itself: a, b, c for a -> b -> c -> a. To be called after
// components_in_evaluation_order().
[[nodiscard]] std::vector<const Entry *> shortest_cycle(const Entry &entry);

} // namespace playground
