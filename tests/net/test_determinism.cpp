#include "../determinism/packet_hashes.hpp"

#include <doctest/doctest.h>

#include <string>

TEST_CASE("determinism: fixed motion leads to the same packets as on all other machines") {
	for (const determinism::Result &result : determinism::results()) {
		CAPTURE(std::string(result.name));
		CHECK(result.actual == result.expected);
	}
}
