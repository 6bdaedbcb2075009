#pragma once

#include "cga/text/text_error.hpp"
#include "playground/document/document_size.hpp"
#include "playground/document/document_state.hpp"
#include "playground/document/entry_index.hpp"
#include "playground/document/literal.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace playground {

// The names of the entries whose value or error changed, dependencies first, including added and removed names. After an
// error the document is unchanged.
using ChangeResult = cga::Result<std::vector<std::string>, Error>;

// Named expressions in user-defined order. An expression may refer to any entry, including later ones, so moving
// an entry changes no value. Each change immediately recomputes the entries that depend on it, and no others.
//
// An entry with an invalid expression is kept, with an error. Invalid or duplicate names, changes of entries that do not
// exist, and changes beyond the limits of document_size.hpp are refused.
//
// To undo a change, restore() the state() from before it, or apply the inverse operation.
class Document {
public:
	static constexpr size_t MAX_ENTRIES = playground::MAX_ENTRIES;

	Document() = default;
	Document(Document &&) = default;
	Document &operator=(Document &&) = default;

	[[nodiscard]] size_t size() const { return _entries.size(); }
	[[nodiscard]] const Entry &at(size_t index) const { return *_entries[index]; }
	// Null if the entry does not exist.
	[[nodiscard]] const Entry *find(std::string_view name) const;
	// size() if the entry does not exist.
	[[nodiscard]] size_t index_of(std::string_view name) const;
	// The entries that depend on it, directly or indirectly, in the order of the document.
	[[nodiscard]] std::vector<std::string> dependents_of(std::string_view name) const;

	// Whether a new entry may have this name: check_name() accepts it and no entry has it.
	cga::Result<void, Error> check_new_name(std::string_view name) const;

	// Inserts an entry before `index`, or at the end if `index` is at least size().
	ChangeResult add(std::string_view name, std::string_view text, size_t index = MAX_ENTRIES);
	ChangeResult set_expression(std::string_view name, std::string_view text);
	// Also renames it in all expressions, which otherwise stay as typed.
	ChangeResult rename(std::string_view from, std::string_view to);
	ChangeResult remove(std::string_view name);
	// `index` is the index of the entry after the move.
	ChangeResult move(std::string_view name, size_t index);
	// Sets a parameter of a free object (parameters.hpp). Refused if the expression would lose its value, for example with
	// a negative radius.
	ChangeResult set_parameter(std::string_view name, std::string_view parameter, const LiteralValue &value);
	ChangeResult set_attribute(std::string_view name, std::string_view key, const AttributeValue &value);

	[[nodiscard]] const DocumentSize &document_size() const { return _size; }
	[[nodiscard]] const Attributes &attributes() const { return _attributes; }
	ChangeResult set_document_attribute(std::string_view key, const AttributeValue &value);

	[[nodiscard]] DocumentState state() const;
	// Replaces everything. Entries with invalid or duplicate names are left out.
	ChangeResult restore(DocumentState state);

	// The value of an expression that may refer to entries without becoming one. Referring to an entry with an error is an
	// error.
	[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(std::string_view text) const;
	// Evaluates `text` as if it were the expression of the entry `name`, or of a new entry. The result is not part of the
	// document or of its graph. The cost depends on the entries that the expression refers to, not on the document's size.
	[[nodiscard]] Entry trial_entry(std::string_view name, std::string_view text) const;

private:
	Entry *find_mutable(std::string_view name);
	void set_expression(Entry &entry, std::string text, cga::TextResult<Expression> expression);
	// The entries whose error may suggest another name, now that an entry was added or removed.
	[[nodiscard]] std::vector<Entry *> entries_with_suggestion() const;
	// Refused if the document would become too large.
	cga::Result<void, Error> replace_size(const DocumentSize &before, const DocumentSize &after);
	ChangeResult change_attribute(Attributes &attributes, std::string_view key, const AttributeValue &value);
	ChangeResult change(const std::vector<Entry *> &stale, std::vector<std::string> names = {});

	std::vector<std::unique_ptr<Entry>> _entries;
	EntryIndex _index;
	Attributes _attributes;
	DocumentSize _size = size_of_empty_document();
};

} // namespace playground
