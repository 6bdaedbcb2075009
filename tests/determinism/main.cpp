#include "packet_hashes.hpp"

#include <cinttypes>
#include <cstdio>

/// Prints the hashes; fails if one is not the expected one.
int main() {
	bool is_equal = true;
	for (const determinism::Result &result : determinism::results()) {
		std::printf("%s 0x%016" PRIx64 "%s\n", result.name, result.actual, result.actual == result.expected ? "" : " UNEXPECTED");
		is_equal = is_equal && result.actual == result.expected;
	}
	return is_equal ? 0 : 1;
}
