#include "playground/document/document.hpp"

#include "playground/document/dependency_graph.hpp"
#include "playground/document/missing_entry.hpp"
#include "playground/document/parameters.hpp"
#include "playground/document/pasted_text.hpp"
#include "playground/document/reevaluate.hpp"
#include "playground/document/rename_variable.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/names.hpp"
#include "playground/expression/parser.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace playground {

namespace {

Change refused(std::string error) {
	return { std::move(error), {} };
}

Change no_entry(std::string_view name) {
	return refused("there is no entry '" + std::string(name) + "'");
}

} // namespace

const Entry *Document::find(std::string_view name) const {
	const auto found = _index.find(name);
	return found == _index.end() ? nullptr : found->second;
}

Entry *Document::own_entry(std::string_view name) {
	return const_cast<Entry *>(find(name));
}

size_t Document::index_of(std::string_view name) const {
	const Entry *entry = find(name);
	return size_t(std::find_if(_entries.begin(), _entries.end(), [entry](const std::unique_ptr<Entry> &candidate) { return candidate.get() == entry; }) - _entries.begin());
}

std::vector<std::string> Document::dependents_of(std::string_view name) const {
	std::vector<std::string> names;
	const auto found = _index.find(name);
	if (found == _index.end()) {
		return names;
	}
	std::vector<Entry *> dependents = with_dependents({ found->second });
	dependents.erase(dependents.begin());
	std::sort(dependents.begin(), dependents.end());
	for (const std::unique_ptr<Entry> &entry : _entries) {
		if (std::binary_search(dependents.begin(), dependents.end(), entry.get())) {
			names.push_back(entry->name);
		}
	}
	return names;
}

std::string Document::new_name_error(std::string_view name) const {
	if (std::string error = name_error(name); !error.empty()) {
		return error;
	}
	return find(name) ? "there is an entry '" + std::string(name) + "' already" : std::string();
}

void Document::set_text(Entry &entry, std::string_view text) {
	entry.text = text;
	cga::TextResult<Expression> expression = parse(text);
	entry.expression = expression ? std::optional<Expression>(*expression) : std::nullopt;
	entry.syntax_error = expression ? std::string() : expression.error().describe();
	connect(entry, _index);
}

std::vector<Entry *> Document::entries_that_lack_others() const {
	std::vector<Entry *> found;
	for (const std::unique_ptr<Entry> &entry : _entries) {
		if (entry->lacks_dependency()) {
			found.push_back(entry.get());
		}
	}
	return found;
}

Change Document::change(const std::vector<Entry *> &stale, std::vector<std::string> names) {
	const std::set<std::string> came_or_went(names.begin(), names.end());
	for (const Entry *entry : reevaluate(stale, _index)) {
		if (came_or_went.count(entry->name) == 0) {
			names.push_back(entry->name);
		}
	}
	return { {}, std::move(names) };
}

Change Document::add(std::string_view name, std::string_view text, size_t index) {
	if (std::string error = new_name_error(name); !error.empty()) {
		return refused(std::move(error));
	}
	if (_entries.size() >= MAX_ENTRIES) {
		return refused("a document has at most " + std::to_string(MAX_ENTRIES) + " entries");
	}
	auto added = std::make_unique<Entry>();
	Entry &entry = *added;
	entry.name = name;
	_entries.insert(_entries.begin() + ptrdiff_t(std::min(index, _entries.size())), std::move(added));
	_index.emplace(entry.name, &entry);
	// Those that waited for the name, and those that might have meant it.
	std::vector<Entry *> stale = entries_that_lack_others();
	for (Entry *waiting : stale) {
		connect(*waiting, _index);
	}
	set_text(entry, pasted_expression(text));
	stale.push_back(&entry);
	return change(stale, { entry.name });
}

Change Document::set_expression(std::string_view name, std::string_view text) {
	Entry *entry = own_entry(name);
	if (!entry) {
		return no_entry(name);
	}
	const std::string expression = pasted_expression(text);
	if (entry->text == expression) {
		return {};
	}
	set_text(*entry, expression);
	return change({ entry });
}

Change Document::rename(std::string_view from, std::string_view to) {
	Entry *entry = own_entry(from);
	if (!entry) {
		return no_entry(from);
	}
	if (from == to) {
		return {};
	}
	if (std::string error = new_name_error(to); !error.empty()) {
		return refused(std::move(error));
	}
	std::vector<std::pair<Entry *, std::string>> rewritten;
	for (const std::unique_ptr<Entry> &candidate : _entries) {
		if (candidate->expression && !candidate->expression->refers_to(from)) {
			continue;
		}
		std::string text = candidate->expression ? candidate->expression->renamed(from, to) : with_variable_renamed(candidate->text, from, to);
		if (text.size() > MAX_TEXT_LENGTH && candidate->text.size() <= MAX_TEXT_LENGTH) {
			return refused("the expression of '" + candidate->name + "' would become longer than " + std::to_string(MAX_TEXT_LENGTH) + " bytes; choose a shorter name");
		}
		if (text != candidate->text) {
			rewritten.emplace_back(candidate.get(), std::move(text));
		}
	}
	const std::string old_name = entry->name;
	_index.erase(old_name);
	entry->name = to;
	_index.emplace(entry->name, entry);
	std::vector<Entry *> stale = entries_that_lack_others();
	for (Entry *waiting : stale) {
		connect(*waiting, _index);
	}
	for (const auto &[dependent, text] : rewritten) {
		set_text(*dependent, text);
		stale.push_back(dependent);
	}
	stale.push_back(entry);
	return change(stale, { old_name, entry->name });
}

Change Document::remove(std::string_view name) {
	Entry *entry = own_entry(name);
	if (!entry) {
		return no_entry(name);
	}
	const std::string old_name = entry->name;
	disconnect(*entry);
	for (Entry *dependent : entry->dependents) {
		std::replace(dependent->dependencies.begin(), dependent->dependencies.end(), entry, static_cast<Entry *>(nullptr));
	}
	_entries.erase(_entries.begin() + ptrdiff_t(index_of(old_name)));
	_index.erase(old_name);
	return change(entries_that_lack_others(), { old_name });
}

Change Document::move(std::string_view name, size_t index) {
	const size_t from = index_of(name);
	if (from == size()) {
		return no_entry(name);
	}
	if (index >= size()) {
		return refused("the index " + std::to_string(index) + " is not in 0.." + std::to_string(size() - 1));
	}
	const auto place = [this](size_t at) { return _entries.begin() + ptrdiff_t(at); };
	if (from < index) {
		std::rotate(place(from), place(from + 1), place(index + 1));
	} else {
		std::rotate(place(index), place(from), place(from + 1));
	}
	return {};
}

Change Document::set_parameter(std::string_view name, std::string_view parameter, const LiteralValue &value) {
	const Entry *entry = find(name);
	if (!entry) {
		return no_entry(name);
	}
	Rewritten rewritten = with_parameter(entry->text, parameter, value);
	if (!rewritten.error.empty()) {
		return refused(std::move(rewritten.error));
	}
	if (const cga::TextResult<cga::Multivector> result = evaluate(rewritten.text); !result && entry->outcome.value) {
		return refused(result.error().message);
	}
	return set_expression(name, rewritten.text);
}

Change Document::set_attribute(std::string_view name, std::string_view key, const AttributeValue &value) {
	Entry *entry = own_entry(name);
	if (!entry) {
		return no_entry(name);
	}
	if (std::string error = attribute_error(key, value); !error.empty()) {
		return refused(std::move(error));
	}
	playground::set_attribute(entry->attributes, key, value);
	return {};
}

Change Document::set_document_attribute(std::string_view key, const AttributeValue &value) {
	if (std::string error = attribute_error(key, value); !error.empty()) {
		return refused(std::move(error));
	}
	playground::set_attribute(_attributes, key, value);
	return {};
}

DocumentState Document::state() const {
	DocumentState state;
	state.attributes = _attributes;
	for (const std::unique_ptr<Entry> &entry : _entries) {
		state.entries.push_back({ entry->name, entry->text, entry->attributes });
	}
	return state;
}

Change Document::restore(const DocumentState &state) {
	std::map<std::string, std::unique_ptr<Entry>, std::less<>> old;
	for (std::unique_ptr<Entry> &entry : _entries) {
		entry->dependencies.clear();
		entry->dependents.clear();
		std::string name = entry->name;
		old.emplace(std::move(name), std::move(entry));
	}
	_entries.clear();
	_index.clear();
	_attributes = state.attributes;
	std::vector<std::string> names;
	std::vector<Entry *> all;
	for (const EntryState &wanted : state.entries) {
		if (!new_name_error(wanted.name).empty() || size() >= MAX_ENTRIES) {
			continue;
		}
		const auto found = old.find(wanted.name);
		const bool is_new = found == old.end();
		_entries.push_back(is_new ? std::make_unique<Entry>() : std::move(found->second));
		Entry &entry = *_entries.back();
		if (is_new) {
			names.push_back(wanted.name);
			entry.name = wanted.name;
		} else {
			old.erase(found);
		}
		entry.attributes = wanted.attributes;
		_index.emplace(entry.name, &entry);
		all.push_back(&entry);
		if (is_new || entry.text != wanted.text) {
			// Connected below, when all names are there.
			set_text(entry, wanted.text);
		}
	}
	for (const auto &gone : old) {
		names.push_back(gone.first);
	}
	for (Entry *entry : all) {
		entry->dependents.clear();
		entry->dependencies.clear();
	}
	for (Entry *entry : all) {
		connect(*entry, _index);
	}
	return change(all, std::move(names));
}

cga::TextResult<cga::Multivector> Document::evaluate(std::string_view text) const {
	const cga::TextResult<Expression> expression = parse(text);
	if (!expression) {
		return expression.error();
	}
	std::vector<const cga::Multivector *> values;
	for (const std::string &name : expression->variables()) {
		const Entry *entry = find(name);
		if (!entry || !entry->outcome.value) {
			return cga::text_error(text, expression->first_use(values.size()).offset, entry ? "'" + name + "' has an error; " + entry->outcome.error : missing_entry(name, _index));
		}
		values.push_back(&*entry->outcome.value);
	}
	return playground::evaluate(*expression, values);
}

} // namespace playground
