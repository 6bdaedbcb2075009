#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/text/text_error.hpp"
#include "playground/document/attributes.hpp"
#include "playground/expression/expression.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace playground {

// Why an entry has no value.
struct EntryError {
	std::string message; // "column 3: ..."
	std::string cause; // the name of the entry where the error arose: this one, or one it depends on
	bool is_cycle = false; // the entry depends on itself
};

using EntryValue = cga::Result<cga::Multivector, EntryError>;

// Compares coefficients bit for bit, so that incremental and full evaluation give the same results.
[[nodiscard]] bool is_same(const EntryValue &left, const EntryValue &right);

struct Entry;

// That the expression of one entry refers to another.
struct Reference {
	Entry *from;
	size_t variable; // index into from->expression->variables() and from->dependencies
};

// A named expression of a document and its value. EntryIndex keeps dependencies, slots and references.
struct Entry {
	std::string name;
	std::string text; // of the expression, as typed
	Attributes attributes;

	cga::TextResult<Expression> expression = cga::TextError();
	EntryValue value = EntryError();

	// The entries that expression->variables() refer to, in that order; null where no such entry exists.
	std::vector<Entry *> dependencies;
	// For each dependency the index of the reference to it, in its `references` or among those that wait for its name.
	std::vector<size_t> slots;
	// From the entries that depend directly on this one, each once.
	std::vector<Reference> references;

	// The number of the last graph traversal that visited this entry, its mark, and the index of its component.
	uint64_t visit = 0;
	int mark = 0;
	size_t component = 0;
};

} // namespace playground
