#pragma once

#include "playground/document/entry.hpp"

#include <vector>

// Which entries an entry is computed from. Walks keep their place on a stack of their own, so that no chain is too long.

namespace playground {

// Looks the expression's variables up, and tells those that are found; what was connected before is not any more.
void connect(Entry &entry, const EntryIndex &index);
// Takes the entry out of the dependents of others.
void disconnect(Entry &entry);

// `entries` and all that depend on them, each once.
[[nodiscard]] std::vector<Entry *> with_dependents(const std::vector<Entry *> &entries);

// Entries that refer to each other in a circle, or one alone.
struct Component {
	std::vector<Entry *> members;
	bool is_cycle = false;
};

// The entries in an order of evaluation: components after those they depend on. Dependencies outside of `entries` are left
// out. (Tarjan, Depth-first search and linear graph algorithms, 1972.)
[[nodiscard]] std::vector<Component> in_order_of_evaluation(const std::vector<Entry *> &entries);

// The shortest way from an entry of a cycle back to itself: a, b, c for a -> b -> c -> a.
[[nodiscard]] std::vector<const Entry *> shortest_cycle(const Entry &entry, const Component &component);

} // namespace playground
