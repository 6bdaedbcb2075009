#pragma once

#include "net/delivery/packet.hpp"
#include "net/stream/stream_header.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace net {

/// Reorders chunks and reassembles windows from them.
class ChunkBuffer {
public:
	/// Receive window: the number of chunks that the buffer keeps, from the next one on.
	static constexpr uint8_t AHEAD = 128;

	/// Continues the stream at chunk `next`. Keeps later chunks that have already arrived.
	void restart(uint8_t next);
	/// Drops all chunks. Until `restart`, the buffer keeps every new chunk, as it does not know which one comes next.
	void forget();
	/// Stores a chunk and returns its full 8-bit number; std::nullopt if it is a duplicate, too far ahead, or short and arrives
	/// before `restart`.
	std::optional<uint8_t> add(const ChunkItem &chunk);
	/// If the next window is complete, replaces `window` with it, advances past it, and returns its checksum.
	std::optional<WindowCheck> take_window(std::vector<uint8_t> &window);
	/// True if the next chunks do not form a window: the first one is not marked `first`, or a later one is.
	[[nodiscard]] bool is_broken() const { return _broken; }
	[[nodiscard]] AckItem ack() const;

private:
	struct Slot {
		bool full = false;
		bool first = false;
		bool last = false;
		WindowCheck check;
		std::vector<uint8_t> bytes;
	};

	[[nodiscard]] uint8_t first_missing() const;
	/// Empties a slot and keeps its memory for the next chunk.
	void empty(Slot &slot);

	std::array<Slot, 256> _slots;
	std::vector<std::vector<uint8_t>> _spare;
	uint8_t _next = 0; // the first chunk of the next window
	bool _started = false;
	bool _broken = false;
};

} // namespace net
