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
	static constexpr std::uint32_t RING = 256;

	struct Chunk {
		std::array<std::uint8_t, std::size_t(MOST_PACKET_BYTES)> bytes;
		std::size_t size = 0;
		bool first = false;
		bool last = false;
		std::uint8_t check = 0;
	};

	ChunkRing() :
			chunks_(RING) {}

	/// Cuts a window up.
	void push_window(const std::vector<std::uint8_t> &window, std::uint8_t check);
	[[nodiscard]] const Chunk &chunk(std::uint32_t number) const { return chunks_[number % RING]; }
	/// The number that the next chunk will get.
	[[nodiscard]] std::uint32_t next() const { return next_; }

private:
	std::vector<Chunk> chunks_;
	std::uint32_t next_ = 0;
};

} // namespace net
