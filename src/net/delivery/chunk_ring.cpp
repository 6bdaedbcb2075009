#include "net/delivery/chunk_ring.hpp"

#include <algorithm>

namespace net {

void ChunkRing::push_window(const std::vector<std::uint8_t> &window, std::uint8_t check) {
	// Beside a chunk there is room for a round trip.
	constexpr std::size_t MOST = std::size_t(MOST_PACKET_BYTES) - CHUNK_HEADER - ROUND_TRIP_BYTES;
	std::size_t at = 0;
	do {
		Chunk &chunk = chunks_[next_++ % RING];
		const std::size_t size = std::min(MOST, window.size() - at);
		chunk.size = size;
		std::copy_n(window.begin() + std::ptrdiff_t(at), size, chunk.bytes.begin());
		chunk.first = at == 0;
		at += size;
		chunk.last = at == window.size();
		chunk.check = chunk.last ? check : 0;
	} while (at < window.size());
}

} // namespace net
