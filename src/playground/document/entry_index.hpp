#pragma once

#include "playground/document/entry.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace playground {

// The entries of a document by name, and who refers to whom. A reference to a name without an entry waits for one. The cost
// of each function is proportional to the references that it changes (times a logarithm), not to the size of the document.
class EntryIndex {
public:
	[[nodiscard]] size_t size() const { return _entries.size(); }
	// Null if there is none.
	[[nodiscard]] Entry *find(std::string_view name) const;
	[[nodiscard]] std::vector<std::string_view> names() const;

	// Adds an entry, which is not connected yet. References that wait for its name become references to it. Precondition:
	// no entry has its name.
	void add(Entry &entry);
	// Removes an entry. References to it wait for an entry with its name.
	void remove(Entry &entry);

	// Connects an entry to those that its expression refers to. Precondition: it is not connected.
	void connect(Entry &entry);
	// Undoes connect(). Precondition: the expression has not changed since.
	void disconnect(Entry &entry);

private:
	std::map<std::string, Entry *, std::less<>> _entries;
	std::map<std::string, std::vector<Reference>, std::less<>> _waiting;
};

} // namespace playground
