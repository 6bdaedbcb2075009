#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace bench {

/// Writes one row of results, a JSON object on a line of its own. Names hold nothing that JSON would have to escape; a
/// value that is not finite becomes null.
inline void print_row(const char *what, const std::string &subject, size_t n, double value, const char *unit) {
	char number[32] = "null";
	if (value - value == 0.0) {
		std::snprintf(number, sizeof number, "%.9g", value);
	}
	std::printf("{\"suite\": \"network\", \"case\": \"%s\", \"subject\": \"%s\", \"n\": %zu, \"value\": %s, \"unit\": \"%s\"}\n", what, subject.c_str(), n, number, unit);
}

} // namespace bench
