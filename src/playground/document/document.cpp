#include "playground/document/document.hpp"

#include "playground/document/dependency_graph.hpp"
#include "playground/document/parameters.hpp"
#include "playground/document/pasted_text.hpp"
#include "playground/document/reevaluate.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/names.hpp"
#include "playground/expression/parser.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

namespace playground {

namespace {

Error no_entry(std::string_view name) {
	return "there is no entry '" + cga::shortened(name) + "'";
}

DocumentSize size_of(std::string_view name, std::string_view text, const cga::TextResult<Expression> &expression) {
	return size_of_entry(name, text, expression ? expression->operations() : 0);
}

DocumentSize size_of(const Entry &entry) {
	return size_of(entry.name, entry.text, entry.expression);
}

} // namespace

const Entry *Document::find(std::string_view name) const {
	return _index.find(name);
}

Entry *Document::find_mutable(std::string_view name) {
	return _index.find(name);
}

size_t Document::index_of(std::string_view name) const {
	const Entry *entry = find(name);
	return size_t(std::find_if(_entries.begin(), _entries.end(), [entry](const std::unique_ptr<Entry> &candidate) { return candidate.get() == entry; }) - _entries.begin());
}

std::vector<std::string> Document::dependents_of(std::string_view name) const {
	std::vector<std::string> names;
	Entry *entry = _index.find(name);
	if (!entry) {
		return names;
	}
	std::vector<Entry *> dependents = with_dependents({ entry });
	dependents.erase(dependents.begin());
	std::sort(dependents.begin(), dependents.end());
	for (const std::unique_ptr<Entry> &candidate : _entries) {
		if (std::binary_search(dependents.begin(), dependents.end(), candidate.get())) {
			names.push_back(candidate->name);
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

void Document::set_expression(Entry &entry, std::string text, cga::TextResult<Expression> expression) {
	_index.disconnect(entry);
	entry.text = std::move(text);
	entry.expression = std::move(expression);
	_index.connect(entry);
}

std::vector<Entry *> Document::entries_with_suggestion() const {
	std::vector<Entry *> found;
	if (_index.size() > MAX_CANDIDATES + 1) {
		return found;
	}
	for (const std::unique_ptr<Entry> &entry : _entries) {
		if (std::count(entry->dependencies.begin(), entry->dependencies.end(), nullptr) > 0) {
			found.push_back(entry.get());
		}
	}
	return found;
}

cga::Result<void, Error> Document::replace_size(const DocumentSize &before, const DocumentSize &after) {
	DocumentSize size = _size;
	size -= before;
	size += after;
	const cga::Result<void, Error> checked = check_size(size);
	if (checked) {
		_size = size;
	}
	return checked;
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
		return too_many_entries();
	}
	auto added = std::make_unique<Entry>();
	Entry &entry = *added;
	entry.name = name;
	entry.text = pasted_expression(text);
	entry.expression = parse(entry.text);
	if (const cga::Result<void, Error> checked = replace_size({}, size_of(entry)); !checked) {
		return checked.error();
	}
	_entries.insert(_entries.begin() + ptrdiff_t(std::min(index, _entries.size())), std::move(added));
	_index.add(entry);
	std::vector<Entry *> stale = entries_with_suggestion();
	for (const Reference &reference : entry.references) {
		stale.push_back(reference.from);
	}
	_index.connect(entry);
	stale.push_back(&entry);
	return change(stale, { entry.name });
}

ChangeResult Document::set_expression(std::string_view name, std::string_view text) {
	Entry *entry = find_mutable(name);
	if (!entry) {
		return no_entry(name);
	}
	std::string new_text = pasted_expression(text);
	if (entry->text == new_text) {
		return std::vector<std::string>();
	}
	cga::TextResult<Expression> expression = parse(new_text);
	if (const cga::Result<void, Error> checked = replace_size(size_of(*entry), size_of(name, new_text, expression)); !checked) {
		return checked.error();
	}
	set_expression(*entry, std::move(new_text), std::move(expression));
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
	struct Rewritten {
		Entry *entry;
		std::string text;
		cga::TextResult<Expression> expression;
	};
	std::vector<Rewritten> all_rewritten;
	DocumentSize before = size_of_entry(from, {}, 0);
	DocumentSize after = size_of_entry(to, {}, 0);
	for (const std::unique_ptr<Entry> &candidate : _entries) {
		std::string text = with_variable_renamed(candidate->text, from, to);
		if (text.size() > MAX_TEXT_LENGTH && candidate->text.size() <= MAX_TEXT_LENGTH) {
			return Error("the expression of '" + candidate->name + "' would become longer than " + std::to_string(MAX_TEXT_LENGTH) + " bytes; choose a shorter name");
		}
		if (text != candidate->text) {
			cga::TextResult<Expression> expression = parse(text);
			before += size_of(*candidate);
			after += size_of(candidate->name, text, expression);
			all_rewritten.push_back({ candidate.get(), std::move(text), std::move(expression) });
		}
	}
	if (const cga::Result<void, Error> checked = replace_size(before, after); !checked) {
		return checked.error();
	}
	const std::string old_name = entry->name;
	_index.remove(*entry);
	entry->name = to;
	_index.add(*entry);
	std::vector<Entry *> stale = entries_with_suggestion();
	for (const Reference &reference : entry->references) {
		stale.push_back(reference.from);
	}
	for (Rewritten &rewritten : all_rewritten) {
		set_expression(*rewritten.entry, std::move(rewritten.text), std::move(rewritten.expression));
		stale.push_back(rewritten.entry);
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
	_index.disconnect(*entry);
	std::vector<Entry *> stale;
	stale.reserve(entry->references.size());
	for (const Reference &reference : entry->references) {
		stale.push_back(reference.from);
	}
	_size -= size_of(*entry);
	_size -= size_of_attributes(entry->attributes);
	const auto place = _entries.begin() + ptrdiff_t(index_of(old_name));
	_index.remove(*entry);
	_entries.erase(place);
	const std::vector<Entry *> suggesting = entries_with_suggestion();
	stale.insert(stale.end(), suggesting.begin(), suggesting.end());
	return change(stale, { old_name });
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
	return change_attribute(entry->attributes, key, value);
}

ChangeResult Document::set_document_attribute(std::string_view key, const AttributeValue &value) {
	return change_attribute(_attributes, key, value);
}

ChangeResult Document::change_attribute(Attributes &attributes, std::string_view key, const AttributeValue &value) {
	if (const cga::Result<void, Error> checked = check_attribute(key, value); !checked) {
		return checked.error();
	}
	const auto found = attributes.find(key);
	const DocumentSize before = found == attributes.end() ? DocumentSize() : size_of_attribute(key, found->second);
	const DocumentSize after = is_default(key, value) ? DocumentSize() : size_of_attribute(key, value);
	if (const cga::Result<void, Error> checked = replace_size(before, after); !checked) {
		return checked.error();
	}
	playground::set_attribute(attributes, key, value);
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

ChangeResult Document::restore(DocumentState state) {
	// First what can be refused. An entry whose text stays keeps its expression.
	std::vector<std::pair<EntryState *, std::optional<cga::TextResult<Expression>>>> accepted;
	std::unordered_set<std::string_view> seen;
	DocumentSize size = size_of_empty_document();
	size += size_of_attributes(state.attributes);
	for (EntryState &saved : state.entries) {
		if (!check_name(saved.name) || accepted.size() >= MAX_ENTRIES || !seen.insert(saved.name).second) {
			continue;
		}
		const Entry *old = find(saved.name);
		std::optional<cga::TextResult<Expression>> expression;
		if (!old || old->text != saved.text) {
			expression = parse(saved.text);
		}
		size += size_of(saved.name, saved.text, expression ? *expression : old->expression);
		size += size_of_attributes(saved.attributes);
		if (const cga::Result<void, Error> checked = check_size(size); !checked) {
			return checked.error();
		}
		accepted.emplace_back(&saved, std::move(expression));
	}
	if (const cga::Result<void, Error> checked = check_size(size); !checked) {
		return checked.error();
	}
	std::map<std::string, std::unique_ptr<Entry>, std::less<>> old;
	for (std::unique_ptr<Entry> &entry : _entries) {
		entry->dependencies.clear();
		entry->slots.clear();
		entry->references.clear();
		std::string name = entry->name;
		old.emplace(std::move(name), std::move(entry));
	}
	_entries.clear();
	_index = EntryIndex();
	_attributes = std::move(state.attributes);
	_size = size;
	std::vector<std::string> names;
	std::vector<Entry *> all;
	for (auto &[saved, expression] : accepted) {
		const auto found = old.find(saved->name);
		if (found == old.end()) {
			names.push_back(saved->name);
			_entries.push_back(std::make_unique<Entry>());
			_entries.back()->name = std::move(saved->name);
		} else {
			_entries.push_back(std::move(found->second));
			old.erase(found);
		}
		Entry &entry = *_entries.back();
		entry.attributes = std::move(saved->attributes);
		if (expression) {
			entry.text = std::move(saved->text);
			entry.expression = *std::move(expression);
		}
		_index.add(entry);
		all.push_back(&entry);
	}
	for (const auto &removed : old) {
		names.push_back(removed.first);
	}
	for (Entry *entry : all) {
		_index.connect(*entry);
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
