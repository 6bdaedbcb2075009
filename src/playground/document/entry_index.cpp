#include "playground/document/entry_index.hpp"

#include <utility>

namespace playground {

Entry *EntryIndex::find(std::string_view name) const {
	const auto found = _entries.find(name);
	return found == _entries.end() ? nullptr : found->second;
}

std::vector<std::string_view> EntryIndex::names() const {
	std::vector<std::string_view> names;
	names.reserve(_entries.size());
	for (const auto &entry : _entries) {
		names.push_back(entry.first);
	}
	return names;
}

void EntryIndex::add(Entry &entry) {
	_entries.emplace(entry.name, &entry);
	const auto waiting = _waiting.find(entry.name);
	if (waiting == _waiting.end()) {
		return;
	}
	entry.references = std::move(waiting->second);
	_waiting.erase(waiting);
	for (const Reference &reference : entry.references) {
		reference.from->dependencies[reference.variable] = &entry;
	}
}

void EntryIndex::remove(Entry &entry) {
	_entries.erase(entry.name);
	if (entry.references.empty()) {
		return;
	}
	for (const Reference &reference : entry.references) {
		reference.from->dependencies[reference.variable] = nullptr;
	}
	_waiting.emplace(entry.name, std::exchange(entry.references, {}));
}

void EntryIndex::connect(Entry &entry) {
	if (!entry.expression) {
		return;
	}
	for (const std::string &name : entry.expression->variables()) {
		Entry *dependency = find(name);
		std::vector<Reference> &references = dependency ? dependency->references : _waiting[name];
		references.push_back({ &entry, entry.dependencies.size() });
		entry.dependencies.push_back(dependency);
		entry.slots.push_back(references.size() - 1);
	}
}

void EntryIndex::disconnect(Entry &entry) {
	for (size_t variable = 0; variable < entry.dependencies.size(); ++variable) {
		Entry *dependency = entry.dependencies[variable];
		const auto waiting = dependency ? _waiting.end() : _waiting.find(entry.expression->variables()[variable]);
		std::vector<Reference> &references = dependency ? dependency->references : waiting->second;
		// The last reference takes the place of this one.
		const Reference last = references.back();
		references[entry.slots[variable]] = last;
		last.from->slots[last.variable] = entry.slots[variable];
		references.pop_back();
		if (!dependency && references.empty()) {
			_waiting.erase(waiting);
		}
	}
	entry.dependencies.clear();
	entry.slots.clear();
}

} // namespace playground
