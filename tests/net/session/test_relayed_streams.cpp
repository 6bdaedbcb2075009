#include "net/session/relayed_streams.hpp"

#include "../../harness/allocation_counter.hpp"
#include "../hostile_stream.hpp"

#include <doctest/doctest.h>

using namespace net;

namespace {

constexpr PeerId SELF = 7;

/// A client and a section for it with a round-trip item.
struct Client {
	PacketResult accept(uint32_t channel, PeerId owner, double now = 1.0, std::vector<uint8_t> content = { 0xe1, 1, 0 }) {
		std::vector<uint8_t> packet;
		put_section_header(packet, { channel, owner, 0, content.size() }, true);
		packet.insert(packet.end(), content.begin(), content.end());
		return streams.accept(SELF, packet.data(), packet.size(), now, server);
	}

	RelayedStreams streams;
	Receiver server;
};

} // namespace

TEST_CASE("relayed streams: a stream begins when its owner is named, and continues without") {
	Client client;
	CHECK(client.accept(5, 0));
	CHECK(client.streams.find(9) == nullptr);
	CHECK(client.accept(5, 9));
	REQUIRE(client.streams.find(9) != nullptr);
	CHECK(client.accept(5, 0));
	CHECK(client.streams.find(9)->receiver.statistics().packets_received == 2);
	CHECK(client.server.statistics().packets_received == 0);
	CHECK(client.accept(Section::SERVER_CHANNEL, 0));
	CHECK(client.server.statistics().packets_received == 1);
	// The owner has another stream.
	CHECK(client.accept(6, 9));
	CHECK(client.streams.find(9)->channel == 6);
	CHECK(client.streams.find(9)->receiver.statistics().packets_received == 1);
	CHECK(client.accept(5, 9, 2.0)); // late
	CHECK(client.streams.find(9)->channel == 6);
}

TEST_CASE("relayed streams: late packets of a stream that has ended are ignored") {
	Client client;
	CHECK(client.accept(5, 9));
	client.streams.end(5, 1.0);
	CHECK(client.streams.find(9) == nullptr);
	CHECK(client.accept(5, 9, 2.5));
	CHECK(client.streams.find(9) == nullptr);
	CHECK(client.accept(5, 9, 3.5)); // the number is used again
	CHECK(client.streams.find(9) != nullptr);
	client.streams.end(100, 4.0);
	CHECK(client.streams.find(9) != nullptr);
}

TEST_CASE("relayed streams: malformed sections are rejected, those of this peer and of the server as well") {
	Client client;
	CHECK(client.accept(5, SELF).error() == PacketError::BAD_SECTION);
	CHECK(client.accept(5, RelayedStreams::SERVER).error() == PacketError::BAD_SECTION);
	CHECK(client.accept(5, 9, 1.0, {}).error() == PacketError::EMPTY);
	CHECK(client.accept(5, 9, 1.0, { 0xff }).error() == PacketError::UNKNOWN_ITEM);
}

TEST_CASE("relayed streams: the number of streams and their memory are bounded") {
	Client client;
	const size_t before = harness::live_bytes();
	for (uint32_t i = 0; i < 1000; ++i) {
		const PacketResult result = client.accept(i + 1, PeerId(100 + i));
		CHECK((i < RelayedStreams::MAX_STREAMS ? bool(result) : result.error() == PacketError::TOO_MANY_STREAMS));
	}
	for (uint32_t i = 0; i < 10000; ++i) {
		client.streams.end(i, 1.0);
		(void)client.accept(1000 + i, 100);
	}
	CHECK(harness::live_bytes() - before < 6000000);
	client.streams.clear();
	CHECK(harness::live_bytes() - before < 50000);
}

TEST_CASE("relayed streams: the number of bodies in all streams is bounded, and streams that end make room") {
	constexpr uint32_t COUNT = 50000;
	net_test::HostileStream stream(COUNT);
	Client client;
	const auto send = [&](uint32_t channel) {
		PacketResult result;
		for (const std::vector<uint8_t> &packet : stream.snapshot()) {
			const PacketResult sent = client.accept(channel, PeerId(100 + channel), 10.0 * channel, packet);
			result = result ? sent : result;
		}
		return result;
	};
	CHECK(send(1));
	CHECK(send(2));
	const PacketResult third = send(3);
	REQUIRE_FALSE(third);
	CHECK(third.error() == PacketError::TOO_MANY_BODIES);
	CHECK(client.streams.find(103)->receiver.stream_size() == COUNT);
	CHECK_FALSE(client.streams.find(103)->receiver.is_ready());
	client.streams.end(1, 40.0);
	CHECK(send(4));
	CHECK(client.streams.find(104)->receiver.is_ready());
}
