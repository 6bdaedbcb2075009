#include "net/delivery/chunk_ring.hpp"

#include <doctest/doctest.h>

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
			ring.push_window(window, 77, max_packet);
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

TEST_CASE("chunk ring: it keeps the last RING chunks") {
	ChunkRing ring;
	for (uint32_t i = 0; i < 3 * ChunkRing::RING + 5; ++i) {
		CHECK(ring.next() == i);
		ring.push_window({ uint8_t(i), uint8_t(i >> 8) }, uint8_t(i), 256);
	}
	for (uint32_t number = ring.next() - ChunkRing::RING; number < ring.next(); ++number) {
		CHECK(ring.chunk(number).bytes[0] == uint8_t(number));
		CHECK(ring.chunk(number).bytes[1] == uint8_t(number >> 8));
		CHECK(ring.chunk(number).check == uint8_t(number));
	}
}
