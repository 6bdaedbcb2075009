#include "../determinism/packet_hashes.hpp"

#include <doctest/doctest.h>

TEST_CASE("determinism: fixed motion leads to the same packets as on all other machines") {
	for (const determinism::Result &result : determinism::results()) {
		CAPTURE(result.name);
		CHECK(result.actual == result.expected);
	}
}
