#include "net/delivery/packet.hpp"

#include "net/stream/stream_settings.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

std::string problem(const Bytes &packet) {
	PacketContent content;
	const char *error = read_packet(packet.data(), packet.size(), content);
	return error != nullptr ? error : "";
}

PacketContent read(const Bytes &packet) {
	PacketContent content;
	const char *error = read_packet(packet.data(), packet.size(), content);
	CHECK(error == nullptr);
	return content;
}

Bytes counted(size_t size) {
	Bytes bytes(size);
	for (size_t i = 0; i < size; ++i) {
		bytes[i] = uint8_t(i * 7 + 1);
	}
	return bytes;
}

/// One of everything, the last chunk without its length.
Bytes everything() {
	Bytes packet;
	const Bytes bytes = counted(20);
	put_fragment(packet, { 9, 200, 3, 260, bytes.data(), 17 });
	put_round_trip(packet, 0.25);
	put_ack(packet, { 77, 0 });
	put_ack(packet, { 78, 0x8001 });
	put_snapshot_ack(packet, { 9, 3, 0x80000001u });
	put_snapshot_request(packet);
	put_chunk(packet, { 5, true, false, 0, bytes.data(), 20 }, false);
	put_chunk(packet, { 6, false, true, 11, bytes.data(), 5 }, true);
	return packet;
}

} // namespace

TEST_CASE("packet: items take so many bytes and come back") {
	const Bytes bytes = counted(300);
	for (const size_t size : { size_t(0), size_t(1), size_t(300) }) {
		for (int flags = 0; flags < 4; ++flags) {
			for (const bool last_item : { true, false }) {
				Bytes packet;
				const ChunkItem chunk{ uint8_t(250 + flags), (flags & 1) != 0, (flags & 2) != 0, uint8_t((flags & 2) != 0 ? 0xa7 : 0), bytes.data(), size };
				put_chunk(packet, chunk, last_item);
				CHECK(packet.size() == size + 2 + (chunk.last ? 1 : 0) + (last_item ? 0 : 2));
				const PacketContent content = read(packet);
				REQUIRE(content.chunks.size() == 1);
				CHECK(content.chunks[0].number == chunk.number);
				CHECK(content.chunks[0].first == chunk.first);
				CHECK(content.chunks[0].last == chunk.last);
				CHECK(content.chunks[0].check == chunk.check);
				CHECK(Bytes(content.chunks[0].bytes, content.chunks[0].bytes + content.chunks[0].size) == counted(size));
			}
		}
	}
	Bytes shortened;
	ChunkItem whole{ 0xf3, true, true, 0xa5, bytes.data(), 4, true };
	put_chunk(shortened, whole, true);
	CHECK(shortened.size() == 1 + 4);
	const PacketContent one = read(shortened);
	REQUIRE(one.chunks.size() == 1);
	CHECK(one.chunks[0].is_short);
	CHECK(one.chunks[0].number == 3);
	CHECK(one.chunks[0].check == 5);
	CHECK(one.chunks[0].size == 4);

	Bytes packet;
	put_fragment(packet, { 255, 254, 65535, 65535, bytes.data(), 300 });
	CHECK(packet.size() == 300 + FRAGMENT_HEADER);
	const PacketContent content = read(packet);
	REQUIRE(content.parts.size() == 1);
	CHECK(content.parts[0].state == 255);
	CHECK(content.parts[0].next_chunk == 254);
	CHECK(content.parts[0].part == 65535);
	CHECK(content.parts[0].parts == 65535);
	CHECK(Bytes(content.parts[0].bytes, content.parts[0].bytes + content.parts[0].size) == bytes);

	packet.clear();
	put_snapshot_request(packet);
	CHECK(packet.size() == 1);
	CHECK(read(packet).requests_snapshot);
	packet.clear();
	put_snapshot_ack(packet, { 3, 0x1234, 0xdeadbeefu });
	CHECK(packet.size() == 8);
	CHECK(read(packet).snapshot_acks[0].state == 3);
	CHECK(read(packet).snapshot_acks[0].next == 0x1234);
	CHECK(read(packet).snapshot_acks[0].later == 0xdeadbeefu);
}

TEST_CASE("packet: an acknowledgement takes the bytes that its last bit needs") {
	struct Row {
		uint64_t later;
		size_t size;
	};
	for (const Row &row : { Row{ 0, 2 }, Row{ 1, 4 }, Row{ 0x80, 4 }, Row{ 0x100, 5 }, Row{ uint64_t(1) << 56, 11 }, Row{ ~uint64_t(0), 11 } }) {
		Bytes packet;
		put_ack(packet, { 200, row.later });
		CHECK(packet.size() == row.size);
		const PacketContent content = read(packet);
		REQUIRE(content.acks.size() == 1);
		CHECK(content.acks[0].next == 200);
		CHECK(content.acks[0].later == row.later);
	}
	for (const uint8_t length : { 0, 9, 255 }) {
		CHECK(problem({ 0xc1, 1, length, 1, 1, 1, 1, 1, 1, 1, 1, 1 }) == "the packet's list of what arrived is of a wrong length");
	}
}

TEST_CASE("packet: round trips in tenths of a millisecond, up to 6.5 s") {
	struct Row {
		double told;
		double read;
	};
	for (const Row &row : { Row{ 0.0, 0.0001 }, Row{ 0.00012, 0.0001 }, Row{ 0.25, 0.25 }, Row{ 6.5535, 6.5535 }, Row{ 100.0, 6.5535 } }) {
		Bytes packet;
		put_round_trip(packet, row.told);
		CHECK(packet.size() == 3);
		CHECK(read(packet).round_trip == doctest::Approx(row.read).epsilon(1e-12));
	}
}

TEST_CASE("packet: several items in one, in any order; nothing is left of the packet before") {
	const PacketContent content = read(everything());
	CHECK(content.parts.size() == 1);
	CHECK(content.round_trip == 0.25);
	CHECK(content.acks.size() == 2);
	CHECK(content.snapshot_acks.size() == 1);
	CHECK(content.requests_snapshot);
	REQUIRE(content.chunks.size() == 2);
	CHECK(content.chunks[0].size == 20);
	CHECK(content.chunks[1].size == 5);
	CHECK(content.chunks[1].check == 11);
	PacketContent reused = content;
	const Bytes wish = { 0xc2 };
	REQUIRE(read_packet(wish.data(), wish.size(), reused) == nullptr);
	CHECK(reused.chunks.size() + reused.parts.size() + reused.acks.size() + reused.snapshot_acks.size() == 0);
	CHECK(reused.round_trip == 0.0);
}

TEST_CASE("packet: cut off anywhere, it is refused, or all whole items of it are there") {
	const Bytes packet = everything();
	// Behind an item a cut leaves a packet; within the last chunk it shortens that.
	const std::vector<size_t> whole = { 26, 29, 31, 36, 44, 45, 69 };
	CHECK(packet.size() == 77);
	for (size_t size = 0; size < packet.size(); ++size) {
		const std::string error = problem(Bytes(packet.begin(), packet.begin() + ptrdiff_t(size)));
		CAPTURE(size);
		if (size == 0) {
			CHECK(error == "the packet is empty");
		} else if (std::find(whole.begin(), whole.end(), size) != whole.end() || size >= 72) {
			CHECK(error == "");
		} else {
			CHECK((error == "the packet is cut off" || error == "the packet's list of what arrived is of a wrong length"));
		}
	}
}

TEST_CASE("packet: unknown kinds and too long ones are refused") {
	for (int kind = 0x80; kind < 0x100; ++kind) {
		const bool is_chunk = kind < 0xc0 && (kind & 7) == 0;
		const bool known = is_chunk || (kind >= 0xc0 && kind <= 0xc3) || kind == 0xe0 || kind == 0xe1;
		const std::string error = problem({ uint8_t(kind), 1 });
		CAPTURE(kind);
		CHECK((error == "the packet holds something of an unknown kind") == !known);
		CHECK(problem({ 0xc2, uint8_t(kind), 1 }) == (kind == 0xc0 || kind == 0xc2 ? problem({ uint8_t(kind), 1 }) : error));
	}
	Bytes longest(size_t(MAX_PACKET_BYTES), 0);
	longest[0] = 0xb0;
	CHECK(problem(longest) == "");
	longest.push_back(0);
	CHECK(problem(longest) == "the packet is longer than any that is sent");
	CHECK(problem({ 0x88, 1, 0xff, 0xff, 0 }) == "the packet is cut off");
}

TEST_CASE("packet: random bytes point nowhere outside the packet") {
	std::mt19937 random(3);
	for (int round = 0; round < 20000; ++round) {
		Bytes packet(random() % 60);
		for (uint8_t &byte : packet) {
			const uint8_t kinds[] = { 0xe0, 0xe1, 0xc0, 0xc1, 0xc2, 0xc3, 0x88, 0x00 };
			byte = random() % 3 == 0 ? kinds[random() % 8] : uint8_t(random() % 20);
		}
		PacketContent content;
		if (read_packet(packet.data(), packet.size(), content) != nullptr) {
			continue;
		}
		const auto is_inside = [&](const uint8_t *bytes, size_t size) { return bytes >= packet.data() && size <= size_t(packet.data() + packet.size() - bytes); };
		for (const ChunkItem &chunk : content.chunks) {
			CHECK(is_inside(chunk.bytes, chunk.size));
		}
		for (const FragmentItem &part : content.parts) {
			CHECK(is_inside(part.bytes, part.size));
		}
	}
}
