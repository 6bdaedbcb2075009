#include "net/delivery/chunk_ring.hpp"

#include <algorithm>

namespace net {

void ChunkRing::push_window(const std::vector<uint8_t> &window, uint8_t check) {
	// A packet must have room for a chunk of maximum size and a round-trip item.
	constexpr size_t MAX_SIZE = size_t(MAX_PACKET_BYTES) - CHUNK_HEADER - ROUND_TRIP_BYTES;
	size_t at = 0;
	do {
		Chunk &chunk = _chunks[_next++ % RING];
		const size_t size = std::min(MAX_SIZE, window.size() - at);
		chunk.size = size;
		std::copy_n(window.begin() + ptrdiff_t(at), size, chunk.bytes.begin());
		chunk.first = at == 0;
		at += size;
		chunk.last = at == window.size();
		chunk.check = chunk.last ? check : 0;
	} while (at < window.size());
}

} // namespace net
