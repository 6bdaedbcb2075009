#pragma once

#include "../load_cases.hpp"

#include <string>
#include <vector>

namespace bench {

/// The command line options of load_bench.
struct LoadOptions {
	std::vector<std::string> cases; ///< names; empty: all, or one of the changes only if there are any
	LoadChanges changes;
	bool has_changes = false;
	bool is_quick = false;
};

/// Parses arguments: --quick, --case=NAME, and changes as --name=number. Returns an error; empty on success.
[[nodiscard]] std::string parse_options(int count, const char *const *arguments, LoadOptions &options);

} // namespace bench
