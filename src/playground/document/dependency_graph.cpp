#include "playground/document/dependency_graph.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

namespace playground {

namespace {

// Numbers each traversal, so that marks of earlier traversals need not be cleared.
std::atomic<uint64_t> last_visit = 0;

} // namespace

std::vector<Entry *> with_dependents(const std::vector<Entry *> &entries) {
	const uint64_t visit = ++last_visit;
	std::vector<Entry *> found;
	const auto add = [&found, visit](Entry *entry) {
		if (entry->visit != visit) {
			entry->visit = visit;
			found.push_back(entry);
		}
	};
	std::for_each(entries.begin(), entries.end(), add);
	for (size_t index = 0; index < found.size(); ++index) {
		for (const Reference &reference : found[index]->references) {
			add(reference.from);
		}
	}
	return found;
}

std::vector<Component> components_in_evaluation_order(const std::vector<Entry *> &entries) {
	constexpr int NOT_REACHED = -1;
	constexpr int DONE = -2;
	struct Step {
		Entry *entry;
		size_t next; // index of the next dependency to visit
		int lowest; // the lowest mark reachable from here (Tarjan's lowlink)
	};
	const uint64_t visit = ++last_visit;
	for (Entry *entry : entries) {
		entry->visit = visit;
		entry->mark = NOT_REACHED;
	}
	std::vector<Component> components;
	std::vector<Step> path;
	std::vector<Entry *> open; // reached but not in a component yet; each is marked with its index here
	const auto reach = [&path, &open](Entry *entry) {
		entry->mark = int(open.size());
		path.push_back({ entry, 0, entry->mark });
		open.push_back(entry);
	};
	for (Entry *start : entries) {
		if (start->mark != NOT_REACHED) {
			continue;
		}
		reach(start);
		while (!path.empty()) {
			Step &step = path.back();
			if (step.next < step.entry->dependencies.size()) {
				Entry *dependency = step.entry->dependencies[step.next++];
				if (!dependency || dependency->visit != visit || dependency->mark == DONE) {
					continue;
				}
				if (dependency->mark == NOT_REACHED) {
					reach(dependency);
				} else {
					step.lowest = std::min(step.lowest, dependency->mark);
				}
				continue;
			}
			const Step done = step;
			path.pop_back();
			if (!path.empty()) {
				path.back().lowest = std::min(path.back().lowest, done.lowest);
			}
			if (done.lowest == done.entry->mark) {
				Component component;
				component.members.assign(open.begin() + done.lowest, open.end());
				const std::vector<Entry *> &dependencies = done.entry->dependencies;
				component.is_cycle = component.members.size() > 1 || std::find(dependencies.begin(), dependencies.end(), done.entry) != dependencies.end();
				open.resize(size_t(done.lowest));
				for (Entry *member : component.members) {
					member->mark = DONE;
					member->component = components.size();
				}
				components.push_back(std::move(component));
			}
		}
	}
	return components;
}

bool is_in_same_component(const Entry &entry, const Entry *other) {
	return other && other->visit == entry.visit && other->component == entry.component;
}

std::vector<const Entry *> shortest_cycle(const Entry &entry) {
	// Breadth-first search; `origin` maps each entry to its predecessor.
	std::map<const Entry *, const Entry *> origin;
	std::vector<const Entry *> reached = { &entry };
	for (size_t index = 0; index < reached.size(); ++index) {
		for (Entry *dependency : reached[index]->dependencies) {
			if (dependency == &entry) {
				std::vector<const Entry *> cycle = { reached[index] };
				while (cycle.back() != &entry) {
					cycle.push_back(origin[cycle.back()]);
				}
				std::reverse(cycle.begin(), cycle.end());
				return cycle;
			}
			if (is_in_same_component(entry, dependency) && origin.emplace(dependency, reached[index]).second) {
				reached.push_back(dependency);
			}
		}
	}
	return {};
}

} // namespace playground
