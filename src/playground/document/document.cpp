#include "playground/document/document.hpp"

#include "playground/document/dependency_graph.hpp"
#include "playground/document/parameters.hpp"
#include "playground/document/pasted_text.hpp"
#include "playground/document/reevaluate.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/names.hpp"
#include "playground/expression/parser.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace playground {

namespace {

Error no_entry(std::string_view name) {
	return "there is no entry '" + std::string(name) + "'";
}

} // namespace

const Entry *Document::find(std::string_view name) const {
	const auto found = _index.find(name);
	return found == _index.end() ? nullptr : found->second;
}

Entry *Document::find_mutable(std::string_view name) {
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

cga::Result<void, Error> Document::check_new_name(std::string_view name) const {
	if (find(name)) {
		return Error("an entry '" + std::string(name) + "' already exists");
	}
	return check_name(name);
}

void Document::set_text(Entry &entry, std::string_view text) {
	entry.text = text;
	entry.expression = parse(text);
	connect(entry, _index);
}

std::vector<Entry *> Document::entries_with_missing_dependency() const {
	std::vector<Entry *> found;
	for (const std::unique_ptr<Entry> &entry : _entries) {
		if (std::count(entry->dependencies.begin(), entry->dependencies.end(), nullptr) > 0) {
			found.push_back(entry.get());
		}
	}
	return found;
}

ChangeResult Document::change(const std::vector<Entry *> &stale, std::vector<std::string> names) {
	const std::set<std::string> added_or_removed(names.begin(), names.end());
	for (const Entry *entry : reevaluate(stale, _index)) {
		if (added_or_removed.count(entry->name) == 0) {
			names.push_back(entry->name);
		}
	}
	return names;
}

ChangeResult Document::add(std::string_view name, std::string_view text, size_t index) {
	if (const cga::Result<void, Error> checked = check_new_name(name); !checked) {
		return checked.error();
	}
	if (_entries.size() >= MAX_ENTRIES) {
		return Error("a document has at most " + std::to_string(MAX_ENTRIES) + " entries");
	}
	auto added = std::make_unique<Entry>();
	Entry &entry = *added;
	entry.name = name;
	_entries.insert(_entries.begin() + ptrdiff_t(std::min(index, _entries.size())), std::move(added));
	_index.emplace(entry.name, &entry);
	// Entries that referred to the name, and those whose error may now suggest it.
	std::vector<Entry *> stale = entries_with_missing_dependency();
	for (Entry *dependent : stale) {
		connect(*dependent, _index);
	}
	set_text(entry, pasted_expression(text));
	stale.push_back(&entry);
	return change(stale, { entry.name });
}

ChangeResult Document::set_expression(std::string_view name, std::string_view text) {
	Entry *entry = find_mutable(name);
	if (!entry) {
		return no_entry(name);
	}
	const std::string expression = pasted_expression(text);
	if (entry->text == expression) {
		return std::vector<std::string>();
	}
	set_text(*entry, expression);
	return change({ entry });
}

ChangeResult Document::rename(std::string_view from, std::string_view to) {
	Entry *entry = find_mutable(from);
	if (!entry) {
		return no_entry(from);
	}
	if (from == to) {
		return std::vector<std::string>();
	}
	if (const cga::Result<void, Error> checked = check_new_name(to); !checked) {
		return checked.error();
	}
	std::vector<std::pair<Entry *, std::string>> rewritten;
	for (const std::unique_ptr<Entry> &candidate : _entries) {
		std::string text = with_variable_renamed(candidate->text, from, to);
		if (text.size() > MAX_TEXT_LENGTH && candidate->text.size() <= MAX_TEXT_LENGTH) {
			return Error("the expression of '" + candidate->name + "' would become longer than " + std::to_string(MAX_TEXT_LENGTH) + " bytes; choose a shorter name");
		}
		if (text != candidate->text) {
			rewritten.emplace_back(candidate.get(), std::move(text));
		}
	}
	const std::string old_name = entry->name;
	_index.erase(old_name);
	entry->name = to;
	_index.emplace(entry->name, entry);
	std::vector<Entry *> stale = entries_with_missing_dependency();
	for (Entry *dependent : stale) {
		connect(*dependent, _index);
	}
	for (const auto &[dependent, text] : rewritten) {
		set_text(*dependent, text);
		stale.push_back(dependent);
	}
	stale.push_back(entry);
	return change(stale, { old_name, entry->name });
}

ChangeResult Document::remove(std::string_view name) {
	Entry *entry = find_mutable(name);
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
	return change(entries_with_missing_dependency(), { old_name });
}

ChangeResult Document::move(std::string_view name, size_t index) {
	const size_t from = index_of(name);
	if (from == size()) {
		return no_entry(name);
	}
	if (index >= size()) {
		return Error("the index " + std::to_string(index) + " is outside 0.." + std::to_string(size() - 1));
	}
	const auto iterator_at = [this](size_t position) { return _entries.begin() + ptrdiff_t(position); };
	if (from < index) {
		std::rotate(iterator_at(from), iterator_at(from + 1), iterator_at(index + 1));
	} else {
		std::rotate(iterator_at(index), iterator_at(from), iterator_at(from + 1));
	}
	return std::vector<std::string>();
}

ChangeResult Document::set_parameter(std::string_view name, std::string_view parameter, const LiteralValue &value) {
	const Entry *entry = find(name);
	if (!entry) {
		return no_entry(name);
	}
	const cga::Result<std::string, Error> text = with_parameter(entry->text, parameter, value);
	if (!text) {
		return text.error();
	}
	if (const cga::TextResult<cga::Multivector> result = evaluate(*text); !result && entry->value) {
		return Error(result.error().message);
	}
	return set_expression(name, *text);
}

ChangeResult Document::set_attribute(std::string_view name, std::string_view key, const AttributeValue &value) {
	Entry *entry = find_mutable(name);
	if (!entry) {
		return no_entry(name);
	}
	if (const cga::Result<void, Error> checked = check_attribute(key, value); !checked) {
		return checked.error();
	}
	playground::set_attribute(entry->attributes, key, value);
	return std::vector<std::string>();
}

ChangeResult Document::set_document_attribute(std::string_view key, const AttributeValue &value) {
	if (const cga::Result<void, Error> checked = check_attribute(key, value); !checked) {
		return checked.error();
	}
	playground::set_attribute(_attributes, key, value);
	return std::vector<std::string>();
}

DocumentState Document::state() const {
	DocumentState state;
	state.attributes = _attributes;
	for (const std::unique_ptr<Entry> &entry : _entries) {
		state.entries.push_back({ entry->name, entry->text, entry->attributes });
	}
	return state;
}

ChangeResult Document::restore(const DocumentState &state) {
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
	for (const EntryState &saved : state.entries) {
		if (!check_new_name(saved.name) || size() >= MAX_ENTRIES) {
			continue;
		}
		const auto found = old.find(saved.name);
		const bool is_new = found == old.end();
		_entries.push_back(is_new ? std::make_unique<Entry>() : std::move(found->second));
		Entry &entry = *_entries.back();
		if (is_new) {
			names.push_back(saved.name);
			entry.name = saved.name;
		} else {
			old.erase(found);
		}
		entry.attributes = saved.attributes;
		_index.emplace(entry.name, &entry);
		all.push_back(&entry);
		if (is_new || entry.text != saved.text) {
			entry.text = saved.text;
			entry.expression = parse(saved.text);
		}
	}
	for (const auto &removed : old) {
		names.push_back(removed.first);
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
		if (!entry || !entry->value) {
			return cga::text_error(text, expression->first_use(values.size()), entry ? "'" + name + "' has an error; " + entry->value.error().message : missing_entry(name, _index));
		}
		values.push_back(&*entry->value);
	}
	return playground::evaluate(*expression, values);
}

} // namespace playground
