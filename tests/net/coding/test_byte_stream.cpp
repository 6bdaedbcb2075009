#include "net/coding/byte_stream.hpp"

#include <doctest/doctest.h>

using namespace net;

TEST_CASE("byte stream: numbers round-trip in little-endian order") {
	std::vector<uint8_t> bytes;
	put_number(bytes, uint16_t(0x1234));
	put_number(bytes, 0.1f);
	put_number(bytes, -1e300);
	put_number(bytes, uint8_t(7));
	CHECK(bytes.size() == 15);
	CHECK(bytes[0] == 0x34);
	CHECK(bytes[1] == 0x12);
	ByteReader reader(bytes.data(), bytes.size());
	CHECK(reader.read<uint16_t>() == 0x1234);
	CHECK(reader.read<float>() == 0.1f);
	CHECK(reader.read<double>() == -1e300);
	CHECK(reader.take(1) == bytes.data() + 14);
	CHECK(reader.left() == 0);
	CHECK_FALSE(reader.failed());
}

TEST_CASE("byte stream: a number can be read from fewer bytes") {
	const uint8_t bytes[] = { 1, 2, 3 };
	ByteReader reader(bytes, 3);
	CHECK(reader.read<uint64_t>(3) == 0x030201);
	CHECK_FALSE(reader.failed());
}

TEST_CASE("byte stream: reading past the end fails and stays failed") {
	const uint8_t bytes[] = { 1, 2, 3 };
	ByteReader reader(bytes, 3);
	CHECK(reader.read<uint32_t>() == 0);
	CHECK(reader.failed());
	CHECK(reader.left() == 0);
	CHECK(reader.read<uint8_t>() == 0);
	CHECK(reader.take(0) == nullptr);
	CHECK(reader.failed());
}
