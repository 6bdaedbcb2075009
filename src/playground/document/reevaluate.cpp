#include "playground/document/reevaluate.hpp"

#include "playground/document/dependency_graph.hpp"
#include "playground/document/missing_entry.hpp"
#include "playground/expression/evaluate.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace playground {

namespace {

// A way round through more entries is not described.
constexpr size_t MAX_CYCLE_DESCRIBED = 16;

std::string quoted(const std::string &name) {
	return "'" + name + "'";
}

Outcome own_fault(const Entry &entry, std::string error) {
	return { std::nullopt, std::move(error), entry.name, false };
}

// Where the expression first refers to its variable.
Outcome fault_at(const Entry &entry, size_t variable, std::string message, const std::string &cause) {
	return { std::nullopt, cga::text_error(entry.text, entry.expression->first_use(variable).offset, std::move(message)).describe(), cause, false };
}

Outcome evaluated(const Entry &entry, const EntryIndex &index) {
	if (!entry.expression) {
		return own_fault(entry, entry.syntax_error);
	}
	std::vector<const cga::Multivector *> values;
	values.reserve(entry.dependencies.size());
	for (size_t variable = 0; variable < entry.dependencies.size(); ++variable) {
		const Entry *dependency = entry.dependencies[variable];
		if (!dependency) {
			return fault_at(entry, variable, missing_entry(entry.expression->variables()[variable], index), entry.name);
		}
		if (!dependency->outcome.value) {
			const std::string &cause = dependency->outcome.cause;
			const std::string origin = cause == dependency->name ? "" : ", because of " + quoted(cause);
			return fault_at(entry, variable, quoted(dependency->name) + " has an error" + origin, cause);
		}
		values.push_back(&*dependency->outcome.value);
	}
	cga::TextResult<cga::Multivector> result = evaluate(*entry.expression, values);
	return result ? Outcome{ *result, {}, {}, false } : own_fault(entry, result.error().describe());
}

Outcome cycle_fault(const Entry &entry, const Component &component) {
	size_t variable = 0;
	const auto is_member = [&component](const Entry *candidate) {
		return candidate && std::find(component.members.begin(), component.members.end(), candidate) != component.members.end();
	};
	if (component.members.size() > MAX_CYCLE_DESCRIBED) {
		variable = size_t(std::find_if(entry.dependencies.begin(), entry.dependencies.end(), is_member) - entry.dependencies.begin());
		return fault_at(entry, variable, quoted(entry.dependencies[variable]->name) + " depends on " + quoted(entry.name) + ", in a cycle of " + std::to_string(component.members.size()) + " entries", entry.name);
	}
	const std::vector<const Entry *> cycle = shortest_cycle(entry, component);
	const Entry *next = cycle.size() > 1 ? cycle[1] : &entry;
	variable = size_t(std::find(entry.dependencies.begin(), entry.dependencies.end(), next) - entry.dependencies.begin());
	if (next == &entry) {
		return fault_at(entry, variable, quoted(entry.name) + " refers to itself", entry.name);
	}
	std::string way;
	for (const Entry *step : cycle) {
		way += step->name + " -> ";
	}
	return fault_at(entry, variable, quoted(next->name) + " depends on " + quoted(entry.name) + ": " + way + entry.name, entry.name);
}

} // namespace

bool Outcome::is_same_as(const Outcome &other) const {
	if (value.has_value() != other.value.has_value() || error != other.error || cause != other.cause || is_cycle != other.is_cycle) {
		return false;
	}
	return !value || std::memcmp(value->coefficients().data(), other.value->coefficients().data(), sizeof(cga::Multivector::Coefficients)) == 0;
}

std::vector<Entry *> reevaluate(const std::vector<Entry *> &entries, const EntryIndex &index) {
	constexpr int UNCHANGED = 0;
	constexpr int CHANGED = 1;
	constexpr int STALE = 2;
	const std::vector<Entry *> affected = with_dependents(entries);
	const std::vector<Component> components = in_order_of_evaluation(affected);
	for (Entry *entry : affected) {
		entry->mark = UNCHANGED;
	}
	for (Entry *entry : entries) {
		entry->mark = STALE;
	}
	const uint64_t visit = affected.empty() ? 0 : affected.front()->visit;
	const auto has_changed = [visit](const Entry *entry) { return entry && entry->visit == visit && entry->mark == CHANGED; };
	std::vector<Entry *> changed;
	for (const Component &component : components) {
		for (Entry *entry : component.members) {
			if (!component.is_cycle && !entry->outcome.is_cycle && entry->mark != STALE && std::none_of(entry->dependencies.begin(), entry->dependencies.end(), has_changed)) {
				continue;
			}
			Outcome outcome = component.is_cycle ? cycle_fault(*entry, component) : evaluated(*entry, index);
			outcome.is_cycle = component.is_cycle;
			const bool is_same = outcome.is_same_as(entry->outcome);
			entry->mark = is_same ? UNCHANGED : CHANGED;
			if (!is_same) {
				entry->outcome = std::move(outcome);
				changed.push_back(entry);
			}
		}
	}
	return changed;
}

} // namespace playground
