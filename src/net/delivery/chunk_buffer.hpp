#pragma once

#include "net/delivery/packet.hpp"
#include "net/stream/stream_header.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace net {

/// Reorders chunks and reassembles windows from them. Numbers of chunks are modulo 65536.
class ChunkBuffer {
public:
	/// Receive window: the maximum number of chunks that the buffer keeps, from the next one on, and of their bytes.
	static constexpr size_t MAX_AHEAD = 4096;
	static constexpr size_t MAX_BYTES = size_t(8) << 20;

	/// Continues the stream at chunk `next`. Keeps later chunks that have already arrived.
	void restart(uint16_t next);
	/// A snapshot begins to arrive after which the stream continues at `next`. Before the first `restart`, this tells the buffer which
	/// chunks to keep.
	void expect(uint16_t next);
	/// Drops all chunks and waits for `restart`.
	void forget();
	/// Stores a chunk and returns its number; std::nullopt if it is a duplicate, too far ahead, or arrives before `restart` and does
	/// not have its whole number.
	std::optional<uint16_t> add(const ChunkItem &chunk);
	/// If the next window is complete, replaces `window` with it, advances past it, and returns its checksum.
	std::optional<WindowCheck> take_window(std::vector<uint8_t> &window);
	/// True if the next chunks do not form a window: the first one is not marked `first`, or a later one is.
	[[nodiscard]] bool is_broken() const { return _is_broken; }
	/// Acknowledges all chunks that have arrived; AckItem::packets is left to the caller.
	[[nodiscard]] AckItem ack() const;
	/// Number of chunks that have arrived without a gap and are not part of a window that was taken.
	[[nodiscard]] size_t present() const { return _present; }
	/// Size of the chunks kept, in bytes.
	[[nodiscard]] size_t size() const { return _bytes; }

private:
	struct Slot {
		bool full = false;
		bool first = false;
		bool last = false;
		WindowCheck check;
		std::vector<uint8_t> bytes;
	};

	static constexpr size_t MIN_SLOTS = 16; // a power of two, as is the number of slots
	static constexpr size_t MAX_SPARE = 256;

	[[nodiscard]] std::optional<uint16_t> full_number(const ChunkItem &chunk) const;
	[[nodiscard]] Slot &slot(size_t offset) { return _slots[(size_t(_next) + offset) & (_slots.size() - 1)]; }
	[[nodiscard]] bool is_full(size_t offset) const { return offset < _slots.size() && _slots[(size_t(_next) + offset) & (_slots.size() - 1)].full; }
	void grow(size_t offset);
	/// Empties a slot and keeps its memory for the next chunk.
	void empty(Slot &slot);
	/// Drops everything before `next`.
	void skip_to(uint16_t next);
	/// Counts the chunks that have become contiguous.
	void extend();

	std::vector<Slot> _slots = std::vector<Slot>(MIN_SLOTS); // by number, modulo their count
	std::vector<std::vector<uint8_t>> _spare;
	uint16_t _next = 0; // the first chunk of the next window
	size_t _present = 0; // chunks that have arrived without a gap, from _next on
	size_t _end = 0; // offset after the last chunk that has arrived
	size_t _windows = 0; // complete windows among those present
	size_t _bytes = 0;
	bool _is_inside = false; // the window of the last chunk present is not complete
	bool _is_based = false; // _next is known, if only roughly
	bool _is_started = false;
	bool _is_broken = false;
};

} // namespace net
