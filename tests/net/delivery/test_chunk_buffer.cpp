#include "net/delivery/chunk_buffer.hpp"

#include "ack_numbers.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <optional>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

constexpr int MAX_AHEAD = int(ChunkBuffer::MAX_AHEAD);

AckNumbers later(const ChunkBuffer &buffer) {
	return ack_numbers(buffer.ack().later);
}

bool add(ChunkBuffer &buffer, int number, bool first = true, bool last = true, uint8_t check = 0) {
	const uint8_t byte = uint8_t(number);
	ChunkItem chunk;
	chunk.number = uint16_t(number);
	chunk.is_wide = true;
	chunk.first = first;
	chunk.last = last;
	chunk.check = check;
	chunk.bytes = &byte;
	chunk.size = 1;
	const std::optional<uint16_t> added = buffer.add(chunk);
	CHECK(added.value_or(uint16_t(number)) == uint16_t(number));
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

std::unique_ptr<ChunkBuffer> started(uint16_t next) {
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
	CHECK_FALSE(add(*buffer, 200 + MAX_AHEAD));
	CHECK(add(*buffer, 200 + MAX_AHEAD - 1));
	CHECK(add(*buffer, 200));
	CHECK(taken(*buffer) == Bytes{ 200, 255, 201, 255 });
	CHECK_FALSE(add(*buffer, 200));
	CHECK_FALSE(add(*buffer, 201));
}

TEST_CASE("chunk buffer: a short chunk's full number is the one near the first missing chunk") {
	const auto buffer = started(65530);
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
	for (const int number : { 65530, 65532, 65531, 65537, 65536, 65535, 65534, 65533, 65538 }) {
		CHECK(add_short(number) == uint16_t(number));
	}
	CHECK_FALSE(add_short(65534)); // a duplicate, before the first missing one
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
	const auto buffer = started(65534);
	CHECK(buffer->ack().next == 65534);
	CHECK(later(*buffer).empty());
	add(*buffer, 65536);
	add(*buffer, 65539);
	CHECK(buffer->ack().next == 65534);
	CHECK(later(*buffer) == AckNumbers{ 2, 5 });
	add(*buffer, 65534, true, false); // the first chunk of an incomplete window counts as arrived
	CHECK(buffer->ack().next == 65535);
	CHECK(later(*buffer) == AckNumbers{ 1, 4 });
	add(*buffer, 65535, false, true);
	CHECK(taken(*buffer) == Bytes{ 254, 255, 255, 0, 255 });
	CHECK(buffer->ack().next == 1);
	CHECK(later(*buffer) == AckNumbers{ 2 });
	buffer->restart(1);
	for (int i = 1; i <= MAX_AHEAD; ++i) {
		add(*buffer, i, i == 1, false); // never a window
	}
	CHECK(buffer->ack().next == uint16_t(1 + MAX_AHEAD));
	CHECK(later(*buffer).empty());
	CHECK(taken(*buffer) == Bytes{});
}

TEST_CASE("chunk buffer: a chunk that is neither short nor wide has 8 bits of its number") {
	const auto buffer = started(1000);
	const auto add_narrow = [&](int number) {
		ChunkItem chunk;
		chunk.number = uint8_t(number);
		chunk.first = chunk.last = true;
		return buffer->add(chunk);
	};
	for (const int number : { 1127, 1000, 1001, 1064 }) {
		CHECK(add_narrow(number) == number);
	}
	CHECK_FALSE(add_narrow(1000 - 100));
	ChunkBuffer unstarted;
	ChunkItem chunk;
	CHECK_FALSE(unstarted.add(chunk));
}

TEST_CASE("chunk buffer: windows of more than 128 chunks are taken, in any order of arrival") {
	const auto buffer = started(65000);
	for (int i = 999; i >= 0; --i) {
		CHECK(add(*buffer, 65000 + i, i == 0, i == 999));
	}
	Bytes window;
	REQUIRE(buffer->take_window(window));
	CHECK(window.size() == 1000);
	CHECK(window[999] == uint8_t(65999));
	CHECK(buffer->size() == 0);
}

TEST_CASE("chunk buffer: its bytes are bounded, and the first missing chunk always finds room") {
	const auto buffer = started(0);
	const Bytes large(60000);
	const auto add_large = [&](int number) {
		ChunkItem chunk;
		chunk.number = uint16_t(number);
		chunk.is_wide = chunk.first = chunk.last = true;
		chunk.bytes = large.data();
		chunk.size = large.size();
		return buffer->add(chunk).has_value();
	};
	int added = 0;
	for (int number = 1; number < MAX_AHEAD; ++number) {
		added += add_large(number) ? 1 : 0;
	}
	CHECK(added == int(ChunkBuffer::MAX_BYTES / large.size()));
	CHECK(buffer->size() <= ChunkBuffer::MAX_BYTES);
	CHECK(add_large(0));
	Bytes window;
	for (int i = 0; i <= added; ++i) {
		CHECK(buffer->take_window(window));
	}
	CHECK(buffer->size() == 0);
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
	CHECK(later(buffer).empty());
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
