#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace bench {

/// Prints one row of results, a JSON object on one line. A value that is not finite becomes null. Texts are not escaped.
inline void print_row(const char *suite, const char *name, const std::string &subject, size_t n, double value, const char *unit) {
	char number[32] = "null";
	if (value - value == 0.0) {
		std::snprintf(number, sizeof number, "%.9g", value);
	}
	std::printf("{\"suite\": \"%s\", \"case\": \"%s\", \"subject\": \"%s\", \"n\": %zu, \"value\": %s, \"unit\": \"%s\"}\n", suite, name, subject.c_str(), n, number, unit);
}

} // namespace bench
