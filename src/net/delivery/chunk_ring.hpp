#pragma once

#include "net/delivery/packet.hpp"
#include "net/stream_settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// The windows of a stream in pieces, the last RING of them.
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

	/// Cuts a window up.
	void push_window(const std::vector<uint8_t> &window, uint8_t check);
	[[nodiscard]] const Chunk &chunk(uint32_t number) const { return _chunks[number % RING]; }
	/// The number that the next chunk will get.
	[[nodiscard]] uint32_t next() const { return _next; }

private:
	std::vector<Chunk> _chunks;
	uint32_t _next = 0;
};

} // namespace net
