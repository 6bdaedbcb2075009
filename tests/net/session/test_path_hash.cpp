#include "net/session/path_hash.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

TEST_CASE("path hash: published values of FNV-1a, and no collisions among 10,000 numbered names") {
	CHECK(net::path_hash("") == 0x811c9dc5u);
	CHECK(net::path_hash("a") == 0xe40c292cu);
	CHECK(net::path_hash("foobar") == 0xbf9cf968u);
	std::set<uint32_t> bodies;
	for (int i = 0; i < 10000; ++i) {
		const uint32_t body = net::path_body("World/Cubes/Cube" + std::to_string(i));
		CHECK(body < 0x80000000u);
		bodies.insert(body);
	}
	CHECK(bodies.size() == 10000);
}
