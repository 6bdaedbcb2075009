#include "net/delivery/chunk_buffer.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <optional>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

bool add(ChunkBuffer &buffer, int number, bool first = true, bool last = true, uint8_t check = 0) {
	const uint8_t byte = uint8_t(number);
	ChunkItem chunk;
	chunk.number = byte;
	chunk.first = first;
	chunk.last = last;
	chunk.check = check;
	chunk.bytes = &byte;
	chunk.size = 1;
	const std::optional<uint8_t> added = buffer.add(chunk);
	CHECK(added.value_or(byte) == byte);
	return added.has_value();
}

/// The bytes of all complete windows, with a 255 after each.
Bytes taken(ChunkBuffer &buffer) {
	Bytes all;
	Bytes window;
	while (buffer.take_window(window)) {
		all.insert(all.end(), window.begin(), window.end());
		all.push_back(255);
	}
	return all;
}

std::unique_ptr<ChunkBuffer> started(uint8_t next) {
	auto buffer = std::make_unique<ChunkBuffer>();
	buffer->restart(next);
	return buffer;
}

} // namespace

TEST_CASE("chunk buffer: windows are taken in order, in whatever order their chunks arrive") {
	const auto buffer = started(10);
	CHECK(add(*buffer, 12));
	CHECK(add(*buffer, 14, true, false));
	CHECK(taken(*buffer) == Bytes{});
	CHECK(add(*buffer, 10));
	CHECK(taken(*buffer) == Bytes{ 10, 255 });
	CHECK(add(*buffer, 15, false, true, 9));
	CHECK(add(*buffer, 11));
	CHECK(taken(*buffer) == Bytes{ 11, 255, 12, 255 });
	CHECK(add(*buffer, 13));
	Bytes window;
	REQUIRE(buffer->take_window(window));
	const std::optional<WindowCheck> check = buffer->take_window(window);
	REQUIRE(check);
	CHECK(window == Bytes{ 14, 15 });
	CHECK(check->value == 9);
	CHECK(check->mask == 255);
	CHECK_FALSE(buffer->is_broken());
}

TEST_CASE("chunk buffer: duplicates and chunks too far ahead or behind are dropped") {
	const auto buffer = started(200);
	CHECK(add(*buffer, 201));
	CHECK_FALSE(add(*buffer, 201));
	CHECK_FALSE(add(*buffer, 199));
	CHECK_FALSE(add(*buffer, 200 + ChunkBuffer::AHEAD));
	CHECK(add(*buffer, 200 + ChunkBuffer::AHEAD - 1));
	CHECK(add(*buffer, 200));
	CHECK(taken(*buffer) == Bytes{ 200, 255, 201, 255 });
	CHECK_FALSE(add(*buffer, 200));
	CHECK_FALSE(add(*buffer, 201));
}

TEST_CASE("chunk buffer: a short chunk's full number is the one near the first missing chunk") {
	const auto buffer = started(250);
	const auto add_short = [&](int number) {
		const uint8_t byte = uint8_t(number);
		ChunkItem chunk;
		chunk.number = uint8_t(number & 15);
		chunk.is_short = chunk.first = chunk.last = true;
		chunk.check = 5;
		chunk.bytes = &byte;
		chunk.size = 1;
		return buffer->add(chunk);
	};
	for (const int number : { 250, 252, 251, 257, 256, 255, 254, 253, 258 }) {
		CHECK(add_short(number) == uint8_t(number));
	}
	CHECK_FALSE(add_short(254)); // a duplicate, before the first missing one
	Bytes window;
	const std::optional<WindowCheck> check = buffer->take_window(window);
	REQUIRE(check);
	CHECK(check->value == 5);
	CHECK(check->mask == 7);
	ChunkBuffer unstarted;
	ChunkItem chunk;
	chunk.is_short = chunk.first = chunk.last = true;
	CHECK_FALSE(unstarted.add(chunk));
}

TEST_CASE("chunk buffer: it acknowledges what has arrived, across the wraparound of numbers") {
	const auto buffer = started(254);
	CHECK(buffer->ack().next == 254);
	CHECK(buffer->ack().later == 0);
	add(*buffer, 0);
	add(*buffer, 3);
	CHECK(buffer->ack().next == 254);
	CHECK(buffer->ack().later == (uint64_t(1) << 1 | uint64_t(1) << 4)); // 255 is bit 0
	add(*buffer, 254, true, false); // the first chunk of an incomplete window counts as arrived
	CHECK(buffer->ack().next == 255);
	CHECK(buffer->ack().later == (1 | 1 << 3));
	add(*buffer, 255, false, true);
	CHECK(taken(*buffer) == Bytes{ 254, 255, 255, 0, 255 });
	CHECK(buffer->ack().next == 1);
	CHECK(buffer->ack().later == 1 << 1);
	for (int i = 1; i <= ChunkBuffer::AHEAD; ++i) {
		add(*buffer, i, false, false); // never a window
	}
	CHECK(buffer->ack().next == uint8_t(1 + ChunkBuffer::AHEAD));
	CHECK(buffer->ack().later == 0);
	CHECK(taken(*buffer) == Bytes{});
}

TEST_CASE("chunk buffer: chunks that do not form a window break it, until the next snapshot") {
	for (const bool begins_inside : { true, false }) {
		const auto buffer = started(0);
		if (begins_inside) {
			add(*buffer, 0, false, true);
		} else {
			add(*buffer, 0, true, false);
			add(*buffer, 1, true, true);
		}
		CHECK(taken(*buffer) == Bytes{});
		CHECK(buffer->is_broken());
		buffer->restart(2);
		CHECK_FALSE(buffer->is_broken());
		add(*buffer, 2);
		CHECK(taken(*buffer) == Bytes{ 2, 255 });
	}
}

TEST_CASE("chunk buffer: chunks after the snapshot that arrive before it are kept; earlier chunks are dropped") {
	ChunkBuffer buffer;
	CHECK(add(buffer, 40));
	CHECK(add(buffer, 51));
	CHECK(add(buffer, 50));
	CHECK(taken(buffer) == Bytes{});
	buffer.restart(50);
	CHECK(taken(buffer) == Bytes{ 50, 255, 51, 255 });
	CHECK(add(buffer, 60));
	CHECK(add(buffer, 70));
	// The next snapshot is 150 chunks ahead: 60 and 70 must not be taken for 316 and 326.
	buffer.restart(52 + 150);
	CHECK(buffer.ack().next == 202);
	CHECK(buffer.ack().later == 0);
	for (int number = 202; number < 202 + 60; ++number) {
		CHECK(add(buffer, number));
	}
	for (int number = 202 + 60; number < 202 + 128; ++number) {
		CHECK(add(buffer, number)); // among them 316 and 326
	}
	CHECK(taken(buffer).size() == 256);
}

TEST_CASE("chunk buffer: restarting at an earlier snapshot keeps the chunks after it") {
	const auto buffer = started(10);
	add(*buffer, 10);
	add(*buffer, 11);
	add(*buffer, 13);
	CHECK(taken(*buffer) == Bytes{ 10, 255, 11, 255 });
	buffer->restart(11);
	add(*buffer, 11);
	add(*buffer, 12);
	CHECK(taken(*buffer) == Bytes{ 11, 255, 12, 255, 13, 255 });
}
