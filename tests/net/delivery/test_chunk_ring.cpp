#include "net/delivery/chunk_ring.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace net;

namespace {

std::vector<uint8_t> counted(size_t size) {
	std::vector<uint8_t> bytes(size);
	for (size_t i = 0; i < size; ++i) {
		bytes[i] = uint8_t(i * 7 + i / 256);
	}
	return bytes;
}

} // namespace

TEST_CASE("chunk ring: a window is split into as few chunks as fit into packets") {
	for (const size_t max_packet : { size_t(64), size_t(256), size_t(1100), size_t(65000) }) {
		const size_t max_chunk = max_packet - CHUNK_HEADER - ROUND_TRIP_BYTES;
		for (const size_t size : { size_t(0), size_t(1), max_chunk, max_chunk + 1, 3 * max_chunk, 5 * max_chunk - 1 }) {
			ChunkRing ring;
			const std::vector<uint8_t> window = counted(size);
			ring.push_window(window, 77, 0.1, max_packet, 0);
			CAPTURE(size);
			CHECK(ring.next() == (size == 0 ? 1 : (size + max_chunk - 1) / max_chunk));
			std::vector<uint8_t> joined;
			for (uint32_t number = 0; number < ring.next(); ++number) {
				const ChunkRing::Chunk &chunk = ring.chunk(number);
				CHECK(chunk.bytes.size() <= max_chunk);
				CHECK(chunk.first == (number == 0));
				CHECK(chunk.last == (number + 1 == ring.next()));
				CHECK(chunk.check == (chunk.last ? 77 : 0));
				joined.insert(joined.end(), chunk.bytes.begin(), chunk.bytes.end());
			}
			CHECK(joined == window);
		}
	}
}

TEST_CASE("chunk ring: it keeps as many chunks as are needed") {
	for (const uint32_t needed : { 0u, ChunkRing::MIN_CHUNKS, ~0u }) {
		ChunkRing ring;
		for (uint32_t i = 0; i < ChunkRing::MAX_CHUNKS + 5; ++i) {
			CHECK(ring.next() == i);
			ring.push_window({ uint8_t(i), uint8_t(i >> 8) }, uint8_t(i), 0.1, 256, needed);
		}
		CHECK(ring.next() - ring.oldest() >= ChunkRing::MIN_CHUNKS);
		CHECK(ring.oldest() <= std::max(needed, ring.next() - ChunkRing::MAX_CHUNKS));
		for (uint32_t number = ring.oldest(); number < ring.next(); ++number) {
			CHECK(ring.chunk(number).bytes[0] == uint8_t(number));
			CHECK(ring.chunk(number).bytes[1] == uint8_t(number >> 8));
			CHECK(ring.chunk(number).check == uint8_t(number));
		}
	}
}

TEST_CASE("chunk ring: it knows the size of what follows a chunk, and the rate of the stream") {
	ChunkRing ring;
	CHECK(ring.rate() == 0.0);
	for (int i = 0; i < 300; ++i) {
		ring.push_window(std::vector<uint8_t>(2000), 0, 0.05, 1100, ring.next());
	}
	const uint32_t last = ring.next() - 1;
	CHECK(ring.bytes_from(ring.next()) == 0);
	CHECK(ring.bytes_from(last) == ring.chunk(last).bytes.size() + CHUNK_HEADER);
	CHECK(ring.bytes_from(last - 1) == 2000 + 2 * CHUNK_HEADER);
	CHECK(ring.bytes_from(last - 201) == 101 * (2000 + 2 * CHUNK_HEADER));
	CHECK(ring.rate() == doctest::Approx((2000 + 2 * CHUNK_HEADER) / 0.05));
}
