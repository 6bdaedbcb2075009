#include "net/session/envelope.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

TEST_CASE("an envelope comes back, and nothing else is taken for one") {
	uint8_t bytes[net::ENVELOPE_BYTES + 1] = {};
	for (const net::PacketKind kind : { net::PacketKind::OPEN, net::PacketKind::CLOSE, net::PacketKind::MOTION, net::PacketKind::ACK }) {
		net::write_envelope({ kind, 0xbeef, 200 }, bytes);
		net::Envelope read;
		REQUIRE(net::read_envelope(bytes, sizeof(bytes), read));
		CHECK(read.kind == kind);
		CHECK(read.key == 0xbeef);
		CHECK(read.link == 200);
		CHECK(read.version == net::ENVELOPE_VERSION);
		for (size_t size = 0; size < net::ENVELOPE_BYTES; ++size) {
			CHECK_FALSE(net::read_envelope(bytes, size, read));
		}
		bytes[0] ^= 0x80;
		CHECK_FALSE(net::read_envelope(bytes, sizeof(bytes), read));
	}
}

TEST_CASE("another version is told from something foreign") {
	uint8_t bytes[net::ENVELOPE_BYTES];
	net::write_envelope({ net::PacketKind::MOTION, 1, 2 }, bytes);
	bytes[0] ^= 1 << 3;
	net::Envelope read;
	REQUIRE(net::read_envelope(bytes, sizeof(bytes), read));
	CHECK(read.version != net::ENVELOPE_VERSION);
	CHECK(read.kind == net::PacketKind::MOTION);
}

TEST_CASE("paths as numbers: FNV-1a's published values, and few collisions among numbered names") {
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
