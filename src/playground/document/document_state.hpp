#pragma once

#include "playground/document/attributes.hpp"

#include <string>
#include <vector>

namespace playground {

// What is saved of an entry.
struct EntryState {
	std::string name;
	std::string text;
	Attributes attributes;

	friend bool operator==(const EntryState &left, const EntryState &right) { return left.name == right.name && left.text == right.text && left.attributes == right.attributes; }
};

// What is saved of a document: all that its values follow from.
struct DocumentState {
	std::vector<EntryState> entries;
	Attributes attributes; // of the document as a whole, open keys

	friend bool operator==(const DocumentState &left, const DocumentState &right) { return left.entries == right.entries && left.attributes == right.attributes; }
	friend bool operator!=(const DocumentState &left, const DocumentState &right) { return !(left == right); }
};

} // namespace playground
