#include "playground/document/reevaluate.hpp"

#include "playground/document/dependency_graph.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/functions.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace playground {

namespace {

// The error message for a longer cycle does not list the entries.
constexpr size_t MAX_CYCLE_DESCRIBED = 16;

std::string quoted(const std::string &name) {
	return "'" + name + "'";
}

EntryError own_error(const Entry &entry, const cga::TextError &error) {
	return { error.describe(), entry.name, false };
}

// An error located at the first occurrence of a variable.
EntryError error_at(const Entry &entry, size_t variable, std::string message, const std::string &cause) {
	return { cga::text_error(entry.text, entry.expression->first_use(variable), std::move(message)).describe(), cause, false };
}

EntryValue evaluated(const Entry &entry, const EntryIndex &index) {
	if (!entry.expression) {
		return own_error(entry, entry.expression.error());
	}
	std::vector<const cga::Multivector *> values;
	values.reserve(entry.dependencies.size());
	for (size_t variable = 0; variable < entry.dependencies.size(); ++variable) {
		const Entry *dependency = entry.dependencies[variable];
		if (!dependency) {
			return error_at(entry, variable, missing_entry(entry.expression->variables()[variable], index), entry.name);
		}
		if (!dependency->value) {
			const std::string &cause = dependency->value.error().cause;
			const std::string origin = cause == dependency->name ? "" : ", caused by " + quoted(cause);
			return error_at(entry, variable, quoted(dependency->name) + " has an error" + origin, cause);
		}
		values.push_back(&*dependency->value);
	}
	const cga::TextResult<cga::Multivector> result = evaluate(*entry.expression, values);
	return result ? EntryValue(*result) : own_error(entry, result.error());
}

EntryError cycle_error(const Entry &entry, const Component &component) {
	const auto error = [&entry](size_t variable, std::string message) {
		EntryError found = error_at(entry, variable, std::move(message), entry.name);
		found.is_cycle = true;
		return found;
	};
	const auto is_member = [&entry](const Entry *candidate) { return is_in_same_component(entry, candidate); };
	if (component.members.size() > MAX_CYCLE_DESCRIBED) {
		const size_t variable = size_t(std::find_if(entry.dependencies.begin(), entry.dependencies.end(), is_member) - entry.dependencies.begin());
		return error(variable, "circular dependency of " + std::to_string(component.members.size()) + " entries through " + quoted(entry.dependencies[variable]->name));
	}
	const std::vector<const Entry *> cycle = shortest_cycle(entry);
	const Entry *next = cycle.size() > 1 ? cycle[1] : &entry;
	const size_t variable = size_t(std::find(entry.dependencies.begin(), entry.dependencies.end(), next) - entry.dependencies.begin());
	if (next == &entry) {
		return error(variable, quoted(entry.name) + " refers to itself");
	}
	std::string path;
	for (const Entry *step : cycle) {
		path += step->name + " -> ";
	}
	return error(variable, "circular dependency " + path + entry.name);
}

} // namespace

bool is_same(const EntryValue &left, const EntryValue &right) {
	if (left && right) {
		return std::memcmp(left->coefficients().data(), right->coefficients().data(), sizeof(cga::Multivector::Coefficients)) == 0;
	}
	return !left && !right && left.error().message == right.error().message && left.error().cause == right.error().cause && left.error().is_cycle == right.error().is_cycle;
}

std::string missing_entry(const std::string &name, const EntryIndex &index) {
	const std::vector<std::string_view> names = index.size() <= MAX_CANDIDATES ? index.names() : std::vector<std::string_view>();
	return "there is no entry '" + name + "'" + correction(name, names);
}

std::vector<Entry *> reevaluate(const std::vector<Entry *> &entries, const EntryIndex &index) {
	constexpr int UNCHANGED = 0;
	constexpr int CHANGED = 1;
	constexpr int STALE = 2;
	const std::vector<Entry *> affected = with_dependents(entries);
	const std::vector<Component> components = components_in_evaluation_order(affected);
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
			const bool was_cycle = !entry->value && entry->value.error().is_cycle;
			if (!component.is_cycle && !was_cycle && entry->mark != STALE && std::none_of(entry->dependencies.begin(), entry->dependencies.end(), has_changed)) {
				continue;
			}
			EntryValue value = component.is_cycle ? cycle_error(*entry, component) : evaluated(*entry, index);
			const bool is_unchanged = is_same(value, entry->value);
			entry->mark = is_unchanged ? UNCHANGED : CHANGED;
			if (!is_unchanged) {
				entry->value = std::move(value);
				changed.push_back(entry);
			}
		}
	}
	return changed;
}

} // namespace playground
