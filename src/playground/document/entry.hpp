#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/text/text_error.hpp"
#include "playground/document/attributes.hpp"
#include "playground/expression/expression.hpp"

#include <cstdint>
#include <functional>
#include <map>
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

// A named expression of a document and its value.
struct Entry {
	std::string name;
	std::string text; // of the expression, as typed
	Attributes attributes;

	cga::TextResult<Expression> expression = cga::TextError();
	EntryValue value = EntryError();

	// The entries that expression->variables() refer to, in that order; null where no such entry exists.
	std::vector<Entry *> dependencies;
	// The entries that depend directly on this one, each once.
	std::vector<Entry *> dependents;

	// The number of the last graph traversal that visited this entry, and its mark.
	uint64_t visit = 0;
	int mark = 0;
};

using EntryIndex = std::map<std::string, Entry *, std::less<>>;

} // namespace playground
