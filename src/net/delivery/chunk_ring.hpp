#pragma once

#include "net/delivery/packet.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// The last RING chunks of a stream, for retransmission.
class ChunkRing {
public:
	static constexpr uint32_t RING = 256;

	struct Chunk {
		std::vector<uint8_t> bytes;
		bool first = false;
		bool last = false;
		uint8_t check = 0;
	};

	ChunkRing() :
			_chunks(RING) {}

	/// Splits a window into chunks that fit into packets of `max_packet_size` bytes.
	void push_window(const std::vector<uint8_t> &window, uint8_t check, size_t max_packet_size) {
		// A packet must have room for a chunk of maximum size and a round-trip item.
		const size_t max_size = max_packet_size - CHUNK_HEADER - ROUND_TRIP_BYTES;
		size_t at = 0;
		do {
			Chunk &chunk = _chunks[_next++ % RING];
			const size_t size = std::min(max_size, window.size() - at);
			chunk.bytes.assign(window.begin() + ptrdiff_t(at), window.begin() + ptrdiff_t(at + size));
			chunk.first = at == 0;
			at += size;
			chunk.last = at == window.size();
			chunk.check = chunk.last ? check : 0;
		} while (at < window.size());
	}
	[[nodiscard]] const Chunk &chunk(uint32_t number) const { return _chunks[number % RING]; }
	/// The number of the next chunk.
	[[nodiscard]] uint32_t next() const { return _next; }

private:
	std::vector<Chunk> _chunks;
	uint32_t _next = 0;
};

} // namespace net
