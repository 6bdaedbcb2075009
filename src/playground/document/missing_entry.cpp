#include "playground/document/missing_entry.hpp"

#include "playground/expression/functions.hpp"
#include "playground/expression/names.hpp"

namespace playground {

// Larger documents get no suggestions: the search takes time proportional to the number of entries.
static constexpr size_t MAX_SUGGESTIONS = 100;

std::string missing_entry(const std::string &name, const EntryIndex &index) {
	std::string message = "there is no entry '" + name + "'";
	if (find_function(name)) {
		return message + "; to call the function write '" + name + "('";
	}
	std::vector<std::string_view> names = { "eo", "einf", "pi", "tau" };
	if (index.size() <= MAX_SUGGESTIONS) {
		for (const auto &known : index) {
			names.push_back(known.first);
		}
	}
	const std::string closest(closest_name(name, names));
	return closest.empty() ? message : message + "; did you mean '" + closest + "'?";
}

} // namespace playground
