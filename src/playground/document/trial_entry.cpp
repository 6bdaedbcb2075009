#include "playground/document/dependency_graph.hpp"
#include "playground/document/document.hpp"
#include "playground/document/pasted_text.hpp"
#include "playground/document/reevaluate.hpp"
#include "playground/expression/parser.hpp"

#include <deque>
#include <unordered_set>

namespace playground {

namespace {

// Connects `trial` to copies of the entries that it depends on, as if it replaced the entry with its name.
void connect_to_copies(Entry &trial, const std::vector<const Entry *> &reached, std::deque<Entry> &copies) {
	EntryIndex index;
	index.add(trial);
	for (const Entry *entry : reached) {
		if (entry->name != trial.name) {
			Entry &copy = copies.emplace_back();
			copy.name = entry->name;
			copy.text = entry->text;
			copy.expression = entry->expression;
			index.add(copy);
		}
	}
	index.connect(trial);
	for (Entry &copy : copies) {
		index.connect(copy);
	}
}

} // namespace

Entry Document::trial_entry(std::string_view name, std::string_view text) const {
	Entry trial;
	trial.name = name;
	trial.text = pasted_expression(text);
	if (const Entry *entry = find(name)) {
		trial.attributes = entry->attributes;
	}
	trial.expression = parse(trial.text);
	if (trial.expression) {
		for (const std::string &variable : trial.expression->variables()) {
			trial.dependencies.push_back(_index.find(variable));
		}
	}
	std::vector<const Entry *> reached = { &trial };
	std::unordered_set<const Entry *> seen;
	bool is_cycle = false;
	for (size_t index = 0; index < reached.size(); ++index) {
		const Entry &entry = *reached[index];
		is_cycle = is_cycle || (entry.expression && entry.expression->refers_to(name));
		for (const Entry *dependency : entry.dependencies) {
			if (dependency && seen.insert(dependency).second) {
				reached.push_back(dependency);
			}
		}
	}
	std::deque<Entry> copies;
	if (is_cycle) {
		trial.dependencies.clear();
		connect_to_copies(trial, reached, copies);
	}
	reevaluate({ &trial }, _index);
	trial.dependencies.clear();
	trial.slots.clear();
	trial.references.clear();
	return trial;
}

} // namespace playground
