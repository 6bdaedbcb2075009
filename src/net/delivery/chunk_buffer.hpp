#pragma once

#include "net/delivery/packet.hpp"
#include "net/stream/stream_header.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace net {

/// Reorders chunks until their windows are complete.
class ChunkBuffer {
public:
	/// Chunks ahead of the next one that the buffer keeps.
	static constexpr uint8_t AHEAD = 128;

	/// The next chunk of the stream is `next`. Chunks after it that have arrived are kept.
	void restart(uint8_t next);
	/// Drops everything. Until `restart` the buffer keeps all chunks, as it does not know which comes next.
	void forget();
	/// The chunk's number with all 8 bits. Nothing if the chunk has arrived before, is too far ahead, or is short and comes
	/// before `restart`.
	std::optional<uint8_t> add(const ChunkItem &chunk);
	/// If the next window is complete, replaces `window` with it, advances past it, and returns its checksum.
	std::optional<WindowCheck> take_window(std::vector<uint8_t> &window);
	/// True if the next chunks do not form a window: the first is not marked first, or a later one is.
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
