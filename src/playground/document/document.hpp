#pragma once

#include "cga/text/text_error.hpp"
#include "playground/document/document_state.hpp"
#include "playground/document/entry.hpp"
#include "playground/document/literal.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace playground {

// Why a change was refused (a sentence; the document is as it was), or the names whose value or error changed: exactly
// those, dependencies before what depends on them. A name that came or went is among them.
struct Change {
	std::string error;
	std::vector<std::string> names;

	[[nodiscard]] explicit operator bool() const { return error.empty(); }
};

// Named expressions in an order that a person chose. An expression may refer to any entry, also to later ones: the order
// is for reading, and moving an entry changes no value. Values follow at once: after a change is computed anew what
// depends on it, and nothing else.
//
// An entry whose expression is wrong stays, with an error, and leaves the rest alive. What is refused is what has no place
// in a document: names that no expression can refer to or that are taken, entries that do not exist.
//
// To undo: keep state() from before a change, or the little that the inverse operation needs, and restore() it.
class Document {
public:
	static constexpr size_t MAX_ENTRIES = 65536;

	Document() = default;
	Document(Document &&) = default;
	Document &operator=(Document &&) = default;

	[[nodiscard]] size_t size() const { return _entries.size(); }
	[[nodiscard]] const Entry &at(size_t index) const { return *_entries[index]; }
	// Null if there is none.
	[[nodiscard]] const Entry *find(std::string_view name) const;
	// size() if there is none.
	[[nodiscard]] size_t index_of(std::string_view name) const;
	// All that are computed from it, directly or by way of others, in the order of the document.
	[[nodiscard]] std::vector<std::string> dependents_of(std::string_view name) const;

	// Why an entry to be added cannot have this name, as a sentence; empty if it can.
	[[nodiscard]] std::string new_name_error(std::string_view name) const;

	// Before the entry at `index`; at the end if that is size() or beyond it.
	Change add(std::string_view name, std::string_view text, size_t index = MAX_ENTRIES);
	Change set_expression(std::string_view name, std::string_view text);
	// In all expressions that refer to it as well, of which all else stays as it was typed.
	Change rename(std::string_view from, std::string_view to);
	Change remove(std::string_view name);
	// To the place where it then has that index.
	Change move(std::string_view name, size_t index);
	// Of a free object (parameters.hpp). Refused where the expression would then have no value, as with a radius below 0.
	Change set_parameter(std::string_view name, std::string_view parameter, const LiteralValue &value);
	Change set_attribute(std::string_view name, std::string_view key, const AttributeValue &value);

	[[nodiscard]] const Attributes &attributes() const { return _attributes; }
	Change set_document_attribute(std::string_view key, const AttributeValue &value);

	[[nodiscard]] DocumentState state() const;
	// Entries with a name that is refused, or a second of a name, are left out.
	Change restore(const DocumentState &state);

	// The value of an expression over the entries, which does not become one. It cannot refer to those with an error.
	[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(std::string_view text) const;
	// What the entry of that name, or a new one, would be with this expression; without a name, any new one. It is no part of
	// the document and connected to none of its entries. Takes time for what the expression refers to, not for all entries.
	[[nodiscard]] Entry trial_entry(std::string_view name, std::string_view text) const;

private:
	Entry *own_entry(std::string_view name);
	void set_text(Entry &entry, std::string_view text);
	[[nodiscard]] std::vector<Entry *> entries_that_lack_others() const;
	Change change(const std::vector<Entry *> &stale, std::vector<std::string> names = {});

	std::vector<std::unique_ptr<Entry>> _entries;
	EntryIndex _index;
	Attributes _attributes;
};

} // namespace playground
