#pragma once

#include "net/delivery/packet.hpp"
#include "net/stream/stream_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// The last RING chunks of a stream, for retransmission.
class ChunkRing {
public:
	static constexpr uint32_t RING = 256;

	struct Chunk {
		std::array<uint8_t, size_t(MAX_PACKET_BYTES)> bytes;
		size_t size = 0;
		bool first = false;
		bool last = false;
		uint8_t check = 0;
	};

	ChunkRing() :
			_chunks(RING) {}

	/// Splits a window into chunks.
	void push_window(const std::vector<uint8_t> &window, uint8_t check);
	[[nodiscard]] const Chunk &chunk(uint32_t number) const { return _chunks[number % RING]; }
	/// The number of the next chunk.
	[[nodiscard]] uint32_t next() const { return _next; }

private:
	std::vector<Chunk> _chunks;
	uint32_t _next = 0;
};

} // namespace net
