#pragma once

#include "playground/document/attributes.hpp"

#include <string>
#include <vector>

namespace playground {

// The saved part of an entry.
struct EntryState {
	std::string name;
	std::string text;
	Attributes attributes;

	friend bool operator==(const EntryState &left, const EntryState &right) { return left.name == right.name && left.text == right.text && left.attributes == right.attributes; }
};

// The saved part of a document: everything except the values, which are recomputed.
struct DocumentState {
	std::vector<EntryState> entries;
	Attributes attributes; // of the document itself

	friend bool operator==(const DocumentState &left, const DocumentState &right) { return left.entries == right.entries && left.attributes == right.attributes; }
	friend bool operator!=(const DocumentState &left, const DocumentState &right) { return !(left == right); }
};

} // namespace playground
