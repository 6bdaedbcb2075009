#include "net/stream/packet_error.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace net;

TEST_CASE("packet error: each has a description of its own") {
	std::set<std::string> descriptions;
	for (int error = 0; error <= int(PacketError::RELAY_DIFFERS); ++error) {
		descriptions.insert(describe(PacketError(error)));
	}
	CHECK(descriptions.size() == size_t(PacketError::RELAY_DIFFERS) + 1);
	CHECK(descriptions.count("unknown error") == 0);
}
