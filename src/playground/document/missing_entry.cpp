#include "playground/document/missing_entry.hpp"

#include "playground/expression/functions.hpp"
#include "playground/expression/names.hpp"

namespace playground {

// Larger documents get no suggestions: the search takes time proportional to the number of entries.
static constexpr size_t MAX_CANDIDATES = 100;

std::string missing_entry(const std::string &name, const EntryIndex &index) {
	std::string message = "there is no entry '" + name + "'";
	if (find_function(name)) {
		return message + "; to call the function write '" + name + "('";
	}
	std::vector<std::string_view> names = { "eo", "einf", "pi", "tau" };
	if (index.size() <= MAX_CANDIDATES) {
		for (const auto &known : index) {
			names.push_back(known.first);
		}
	}
	return message + suggestion(name, names);
}

} // namespace playground
