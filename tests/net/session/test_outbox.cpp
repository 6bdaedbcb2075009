#include "net/session/outbox.hpp"

#include "../../harness/allocation_counter.hpp"

#include <doctest/doctest.h>

#include <cstring>

using namespace net;

namespace {

void add(Outbox &outbox, PeerId peer, const char *text, bool reliable = false) {
	std::memcpy(outbox.add(peer, reliable, std::strlen(text)), text, std::strlen(text));
}

struct Sent {
	PeerId peer;
	bool reliable;
	std::vector<uint8_t> bytes;

	bool operator==(const Sent &other) const { return peer == other.peer && reliable == other.reliable && bytes == other.bytes; }
};

std::vector<Sent> drained(Outbox &outbox) {
	std::vector<Sent> sent;
	outbox.drain([&](const Outbox::Packet &packet, const uint8_t *bytes) { sent.push_back({ packet.peer, packet.reliable, { bytes, bytes + packet.size } }); });
	return sent;
}

} // namespace

TEST_CASE("outbox: packets are sent once, in order") {
	Outbox outbox;
	CHECK(drained(outbox).empty());
	add(outbox, 3, "ab");
	add(outbox, 1, "", true);
	add(outbox, 3, "cde", true);
	const std::vector<Sent> sent = { { 3, false, { 'a', 'b' } }, { 1, true, {} }, { 3, true, { 'c', 'd', 'e' } } };
	CHECK(drained(outbox) == sent);
	CHECK(drained(outbox).empty());
}

TEST_CASE("outbox: packets added while it is drained stay for the next time") {
	Outbox outbox;
	add(outbox, 1, "first");
	add(outbox, 2, "second");
	int count = 0;
	outbox.drain([&](const Outbox::Packet &packet, const uint8_t *bytes) {
		++count;
		for (int i = 0; i < 100; ++i) {
			add(outbox, 10 * packet.peer, "reply");
		}
		CHECK(std::memcmp(bytes, packet.peer == 1 ? "first" : "second", packet.size) == 0);
	});
	CHECK(count == 2);
	const std::vector<Sent> replies = drained(outbox);
	REQUIRE(replies.size() == 200);
	CHECK(replies[0] == Sent{ 10, false, { 'r', 'e', 'p', 'l', 'y' } });
	CHECK(replies[199].peer == 20);
}

TEST_CASE("outbox: it may be drained while it is drained") {
	Outbox outbox;
	add(outbox, 1, "a");
	std::vector<PeerId> order;
	outbox.drain([&](const Outbox::Packet &packet, const uint8_t *) {
		order.push_back(packet.peer);
		add(outbox, 2, "b");
		outbox.drain([&](const Outbox::Packet &inner, const uint8_t *) { order.push_back(inner.peer); });
	});
	CHECK(order == std::vector<PeerId>{ 1, 2 });
	CHECK(drained(outbox).empty());
}

TEST_CASE("outbox: a steady stream does not allocate") {
	Outbox outbox;
	size_t before = 0;
	for (int i = 0; i < 10; ++i) {
		before = i == 5 ? harness::allocation_count() : before;
		add(outbox, 1, "packet");
		add(outbox, 2, "packet");
		outbox.drain([](const Outbox::Packet &, const uint8_t *) {});
	}
	CHECK(harness::allocation_count() == before);
}
