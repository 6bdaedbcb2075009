#include "net/session/envelope.hpp"

#include <doctest/doctest.h>

#include <optional>

TEST_CASE("envelope: it round-trips, and other bytes are not taken for one") {
	uint8_t bytes[net::ENVELOPE_BYTES + 1] = {};
	for (const net::PacketKind kind : { net::PacketKind::OPEN, net::PacketKind::CLOSE, net::PacketKind::MOTION, net::PacketKind::ACK }) {
		net::write_envelope({ kind, 200 }, bytes);
		const std::optional<net::Envelope> read = net::read_envelope(bytes, sizeof(bytes));
		REQUIRE(read);
		CHECK(read->kind == kind);
		CHECK(read->link == 200);
		CHECK(read->version == net::ENVELOPE_VERSION);
		for (size_t size = 0; size < net::ENVELOPE_BYTES; ++size) {
			CHECK_FALSE(net::read_envelope(bytes, size));
		}
		for (const size_t byte : { 0, 1, 2 }) {
			bytes[byte] ^= 0x80;
			CHECK_FALSE(net::read_envelope(bytes, sizeof(bytes)));
			bytes[byte] ^= 0x80;
		}
	}
}

TEST_CASE("envelope: one of another version is recognized as an envelope") {
	uint8_t bytes[net::ENVELOPE_BYTES];
	net::write_envelope({ net::PacketKind::MOTION, 2 }, bytes);
	bytes[0] ^= 1 << 3;
	const std::optional<net::Envelope> read = net::read_envelope(bytes, sizeof(bytes));
	REQUIRE(read);
	CHECK(read->version != net::ENVELOPE_VERSION);
	CHECK(read->kind == net::PacketKind::MOTION);
}
