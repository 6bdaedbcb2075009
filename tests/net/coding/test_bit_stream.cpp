#include "net/coding/bit_stream.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace net;

TEST_CASE("bit stream: fields of every width round-trip, in the bytes they need") {
	std::vector<uint8_t> bytes;
	BitWriter writer(bytes);
	int bits = 0;
	for (int width = 0; width <= 56; ++width) {
		writer.write(0x5a5a5a5a5a5a5a5aull, width);
		bits += width;
	}
	writer.flush();
	CHECK(bytes.size() == size_t((bits + 7) / 8));

	BitReader reader(bytes.data(), bytes.size());
	for (int width = 0; width <= 56; ++width) {
		CHECK(reader.read(width) == (0x5a5a5a5a5a5a5a5aull & ((1ull << width) - 1)));
	}
	CHECK(reader.at_end());
	CHECK_FALSE(reader.failed());
}

TEST_CASE("bit stream: reading past the end fails and stays failed") {
	const uint8_t byte = 0xff;
	BitReader reader(&byte, 1);
	CHECK(reader.read(5) == 31);
	CHECK(reader.bits_left() == 3);
	CHECK(reader.read(4) == 0);
	CHECK(reader.failed());
	reader.read(1);
	CHECK(reader.failed());
}

TEST_CASE("bit stream: varints take 7 bits per byte") {
	struct Row {
		uint64_t value;
		size_t size;
	};
	for (const Row &row : { Row{ 0, 1 }, Row{ 127, 1 }, Row{ 128, 2 }, Row{ 16383, 2 }, Row{ 16384, 3 }, Row{ (1ull << 63) - 1, 9 } }) {
		std::vector<uint8_t> bytes;
		BitWriter writer(bytes);
		writer.write_varint(row.value);
		writer.flush();
		CHECK(bytes.size() == row.size);
		BitReader reader(bytes.data(), bytes.size());
		CHECK(reader.read_varint() == row.value);
		CHECK_FALSE(reader.failed());
	}
	const std::vector<uint8_t> unbounded(12, 0xff);
	BitReader reader(unbounded.data(), unbounded.size());
	reader.read_varint();
	CHECK(reader.failed());
}

TEST_CASE("bit stream: zigzag puts small magnitudes first and inverts at the limits") {
	CHECK(zigzag(0) == 0);
	CHECK(zigzag(-1) == 1);
	CHECK(zigzag(1) == 2);
	CHECK(zigzag(-2) == 3);
	for (const int64_t value : { std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max(), int64_t(-12345), int64_t(0) }) {
		CHECK(unzigzag(zigzag(value)) == value);
	}
}

TEST_CASE("bit stream: at_end rejects padding that is not zero") {
	const uint8_t clean = 0x05;
	const uint8_t dirty = 0x85;
	BitReader first(&clean, 1);
	first.read(3);
	CHECK(first.at_end());
	BitReader second(&dirty, 1);
	second.read(3);
	CHECK_FALSE(second.at_end());
}
