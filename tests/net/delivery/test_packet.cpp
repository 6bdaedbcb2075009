#include "net/delivery/packet.hpp"

#include "../../harness/allocation_counter.hpp"
#include "ack_numbers.hpp"
#include "net/stream/stream_settings.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <random>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

std::optional<PacketError> error_of(const Bytes &packet) {
	PacketContent content;
	const PacketResult result = read_packet(packet.data(), packet.size(), content);
	return result ? std::nullopt : std::optional<PacketError>(result.error());
}

PacketContent read(const Bytes &packet) {
	PacketContent content;
	CHECK(read_packet(packet.data(), packet.size(), content));
	return content;
}

Bytes counted(size_t size) {
	Bytes bytes(size);
	for (size_t i = 0; i < size; ++i) {
		bytes[i] = uint8_t(i * 7 + 1);
	}
	return bytes;
}

/// An item of each kind; the last chunk omits its length.
Bytes all_items() {
	Bytes packet;
	const Bytes bytes = counted(20);
	put_fragment(packet, { 9, 2000, 3, 260, bytes.data(), 17 });
	put_round_trip(packet, 0.25);
	put_ack(packet, { 77, 0, {} });
	put_ack(packet, { 78, 0, ack_runs({ 1, 300 }) });
	put_snapshot_ack(packet, { 9, 3, ack_runs({ 1, 32 }) });
	put_snapshot_request(packet);
	put_chunk(packet, { 5, true, false, 0, bytes.data(), 20 }, false);
	put_chunk(packet, { 6, false, true, 11, bytes.data(), 5 }, true);
	return packet;
}

} // namespace

TEST_CASE("packet: items of every kind have the documented size and round-trip") {
	const Bytes bytes = counted(300);
	for (const size_t size : { size_t(0), size_t(1), size_t(300) }) {
		for (int flags = 0; flags < 8; ++flags) {
			for (const bool last_item : { true, false }) {
				Bytes packet;
				const bool is_wide = (flags & 4) != 0;
				const ChunkItem chunk{ uint16_t((is_wide ? 40000 : 240) + flags), (flags & 1) != 0, (flags & 2) != 0, uint8_t((flags & 2) != 0 ? 0xa7 : 0), bytes.data(), size, false, is_wide };
				put_chunk(packet, chunk, last_item);
				CHECK(packet.size() == size + 2 + (is_wide ? 1 : 0) + (chunk.last ? 1 : 0) + (last_item ? 0 : 2));
				const PacketContent content = read(packet);
				REQUIRE(content.chunks.size() == 1);
				CHECK(content.chunks[0].number == chunk.number);
				CHECK(content.chunks[0].is_wide == is_wide);
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
	put_fragment(packet, { 255, 25400, 65535, 65535, bytes.data(), 300 });
	CHECK(packet.size() == 300 + FRAGMENT_HEADER);
	const PacketContent content = read(packet);
	REQUIRE(content.fragments.size() == 1);
	CHECK(content.fragments[0].snapshot == 255);
	CHECK(content.fragments[0].next_chunk == 25400);
	CHECK(content.fragments[0].index == 65535);
	CHECK(content.fragments[0].count == 65535);
	CHECK(Bytes(content.fragments[0].bytes, content.fragments[0].bytes + content.fragments[0].size) == bytes);

	packet.clear();
	put_snapshot_request(packet);
	CHECK(packet.size() == 1);
	CHECK(read(packet).requests_snapshot);
	packet.clear();
	put_snapshot_ack(packet, { 3, 0x1234, ack_runs({ 1, 2, 300 }) });
	CHECK(packet.size() == 10);
	CHECK(read(packet).snapshot_acks[0].snapshot == 3);
	CHECK(read(packet).snapshot_acks[0].next == 0x1234);
	CHECK(ack_numbers(read(packet).snapshot_acks[0].later) == AckNumbers{ 1, 2, 300 });
}

TEST_CASE("packet: an acknowledgement has two numbers for each run of later chunks") {
	struct Row {
		AckNumbers later;
		size_t size;
	};
	for (const Row &row : { Row{ {}, 4 }, Row{ { 1 }, 7 }, Row{ { 7, 8 }, 7 }, Row{ { 1, 3 }, 9 }, Row{ { 127 }, 7 }, Row{ { 128 }, 8 }, Row{ { 20000, 20001, 60000 }, 13 } }) {
		Bytes packet;
		put_ack(packet, { 40000, 17, ack_runs(row.later) });
		CHECK(packet.size() == row.size);
		const PacketContent content = read(packet);
		REQUIRE(content.acks.size() == 1);
		CHECK(content.acks[0].next == 40000);
		CHECK(ack_numbers(content.acks[0].later) == row.later);
		CHECK(content.acks[0].packets == 17);
	}
	AckNumbers odd;
	for (uint32_t number = 1; number < 3 * AckRuns::MAX_RUNS; number += 2) {
		odd.push_back(number);
	}
	Bytes packet;
	put_ack(packet, { 0, 0, ack_runs(odd) });
	odd.resize(AckRuns::MAX_RUNS);
	CHECK(ack_numbers(read(packet).acks[0].later) == odd);

	CHECK(error_of({ 0xc1, 1, 0, 1, 65, 1, 1 }) == PacketError::BAD_ACK); // too many runs
	CHECK(error_of({ 0xc1, 1, 0, 1, 1, 0, 1 }) == PacketError::BAD_ACK); // none missing
	CHECK(error_of({ 0xc1, 1, 0, 1, 1, 1, 0 }) == PacketError::BAD_ACK); // none present
	CHECK(error_of({ 0xc1, 1, 0, 1, 1, 0xff, 0xff, 0x03, 1 }) == PacketError::BAD_ACK); // beyond all numbers
	CHECK(error_of({ 0xc1, 1, 0, 1, 1, 0xff, 0xff, 0xff, 1 }) == PacketError::BAD_ACK); // more than 16 bits
	CHECK(error_of({ 0xc1, 1, 0, 1, 2, 1, 1 }) == PacketError::TRUNCATED);
}

TEST_CASE("packet: round-trip times are sent in tenths of a millisecond, up to 6.5 s") {
	struct Row {
		double sent;
		double read;
	};
	for (const Row &row : { Row{ 0.0, 0.0001 }, Row{ 0.00012, 0.0001 }, Row{ 0.25, 0.25 }, Row{ 6.5535, 6.5535 }, Row{ 100.0, 6.5535 } }) {
		Bytes packet;
		put_round_trip(packet, row.sent);
		CHECK(packet.size() == 3);
		CHECK(read(packet).round_trip == doctest::Approx(row.read).epsilon(1e-12));
	}
}

TEST_CASE("packet: requests to align windows contain the period in microseconds and the shift in tenths of a millisecond") {
	struct Row {
		double period;
		double shift;
		double read_period;
		double read_shift;
	};
	for (const Row &row : { Row{ 0.15, -0.0123, 0.15, -0.0123 }, Row{ 4.0 / 60.0, 0.00002, 0.066667, 0.0 }, Row{ 0.0, 0.0, 1e-6, 0.0 }, Row{ 1e4, 100.0, 1e3, 3.2767 }, Row{ 1.0, -100.0, 1.0, -3.2767 } }) {
		Bytes packet;
		put_alignment(packet, { 201, row.period, row.shift });
		CHECK(packet.size() == 8);
		const PacketContent content = read(packet);
		REQUIRE(content.alignment);
		CHECK(content.alignment->number == 201);
		CHECK(content.alignment->period == doctest::Approx(row.read_period).epsilon(1e-12));
		CHECK(content.alignment->shift == doctest::Approx(row.read_shift).epsilon(1e-12));
		packet.pop_back();
		CHECK(error_of(packet) == PacketError::TRUNCATED);
	}
	CHECK_FALSE(read({ 0xc2 }).alignment);
}

TEST_CASE("packet: it can have several items in any order; reused content keeps nothing of the previous packet") {
	const PacketContent content = read(all_items());
	CHECK(content.fragments.size() == 1);
	CHECK(content.round_trip == 0.25);
	CHECK(content.acks.size() == 2);
	CHECK(content.snapshot_acks.size() == 1);
	CHECK(content.requests_snapshot);
	REQUIRE(content.chunks.size() == 2);
	CHECK(content.chunks[0].size == 20);
	CHECK(content.chunks[1].size == 5);
	CHECK(content.chunks[1].check == 11);
	PacketContent reused = content;
	const Bytes request = { 0xc2 };
	REQUIRE(read_packet(request.data(), request.size(), reused));
	CHECK(reused.chunks.size() + reused.fragments.size() + reused.acks.size() + reused.snapshot_acks.size() == 0);
	CHECK(reused.round_trip == 0.0);
}

TEST_CASE("packet: truncated anywhere, it is rejected or ends after a whole item") {
	const Bytes packet = all_items();
	// Truncated after an item, it is a valid packet; within the last chunk, a packet with a shorter chunk.
	const std::vector<size_t> whole = { 27, 30, 34, 44, 53, 54, 78 };
	CHECK(packet.size() == 86);
	for (size_t size = 0; size < packet.size(); ++size) {
		const std::optional<PacketError> error = error_of(Bytes(packet.begin(), packet.begin() + ptrdiff_t(size)));
		CAPTURE(size);
		if (size == 0) {
			CHECK(error == PacketError::EMPTY);
		} else if (std::find(whole.begin(), whole.end(), size) != whole.end() || size >= 81) {
			CHECK(error == std::nullopt);
		} else {
			CHECK((error == PacketError::TRUNCATED || error == PacketError::BAD_ACK));
		}
	}
}

TEST_CASE("packet: unknown items and packets that are too long are rejected") {
	for (int kind = 0x80; kind < 0x100; ++kind) {
		const bool is_chunk = kind < 0xc0 && (kind & 3) == 0;
		const bool known = is_chunk || (kind >= 0xc0 && kind <= 0xc4) || kind == 0xe0 || kind == 0xe1;
		const std::optional<PacketError> error = error_of({ uint8_t(kind), 1 });
		CAPTURE(kind);
		CHECK((error == PacketError::UNKNOWN_ITEM) == !known);
		CHECK(error_of({ 0xc2, uint8_t(kind), 1 }) == (kind == 0xc0 || kind == 0xc2 ? error_of({ uint8_t(kind), 1 }) : error));
	}
	Bytes longest(StreamSettings::MAX_PACKET_SIZE, 0);
	longest[0] = 0xb0;
	CHECK(error_of(longest) == std::nullopt);
	longest.push_back(0);
	CHECK(error_of(longest) == PacketError::TOO_LONG);
	CHECK(error_of({ 0x88, 1, 0xff, 0xff, 0 }) == PacketError::TRUNCATED);
}

TEST_CASE("packet: items of random bytes lie within the packet") {
	std::mt19937 random(3);
	for (int round = 0; round < 20000; ++round) {
		Bytes packet(random() % 60);
		for (uint8_t &byte : packet) {
			const uint8_t kinds[] = { 0xe0, 0xe1, 0xc0, 0xc1, 0xc2, 0xc3, 0x88, 0x00 };
			byte = random() % 3 == 0 ? kinds[random() % 8] : uint8_t(random() % 20);
		}
		PacketContent content;
		if (!read_packet(packet.data(), packet.size(), content)) {
			continue;
		}
		const auto is_inside = [&](const uint8_t *bytes, size_t size) { return bytes >= packet.data() && size <= size_t(packet.data() + packet.size() - bytes); };
		for (const ChunkItem &chunk : content.chunks) {
			CHECK(is_inside(chunk.bytes, chunk.size));
		}
		for (const FragmentItem &fragment : content.fragments) {
			CHECK(is_inside(fragment.bytes, fragment.size));
		}
	}
}

TEST_CASE("packet: of many acknowledgements, the first ones are kept and all are counted") {
	PacketContent content;
	Bytes packet;
	for (uint16_t i = 0; i < 7000; ++i) {
		put_ack(packet, { i, 0, {} });
		put_snapshot_ack(packet, { 1, i, {} });
	}
	put_snapshot_request(packet);
	const size_t before = harness::live_bytes();
	REQUIRE(read_packet(packet.data(), packet.size(), content));
	CHECK(content.acks.size() == PacketContent::MAX_ACKS);
	CHECK(content.snapshot_acks.size() == PacketContent::MAX_ACKS);
	CHECK(content.acks.back().next == PacketContent::MAX_ACKS - 1);
	CHECK(content.ack_count == 14000);
	CHECK(harness::live_bytes() - before < 8000);
}
