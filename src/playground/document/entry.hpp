#pragma once

#include "cga/algebra/multivector.hpp"
#include "playground/document/attributes.hpp"
#include "playground/expression/expression.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace playground {

// What came out of an entry's expression: a value, or an error and where it comes from.
struct Outcome {
	std::optional<cga::Multivector> value;
	std::string error; // "column 3: ..."; empty where there is a value
	std::string cause; // the entry whose own fault the error is: this one, or one it depends on
	bool is_cycle = false; // the error is that it depends on itself

	// Bit for bit: what is computed from equal outcomes is equal.
	[[nodiscard]] bool is_same_as(const Outcome &other) const;
};

// A named expression of a document, with what it was computed to be.
struct Entry {
	std::string name;
	std::string text; // of the expression, as it was typed
	Attributes attributes;

	std::optional<Expression> expression; // none where the text is none
	std::string syntax_error; // why it is none
	Outcome outcome;

	// As expression->variables(), null where the document has no such entry.
	std::vector<Entry *> dependencies;
	// Those whose dependencies have this one, each once.
	std::vector<Entry *> dependents;

	// The number of the last walk over the graph that came by, and what it noted here.
	uint64_t visit = 0;
	int mark = 0;

	[[nodiscard]] bool lacks_dependency() const;
};

using EntryIndex = std::map<std::string, Entry *, std::less<>>;

} // namespace playground
