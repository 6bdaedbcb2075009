#pragma once

#include "net/delivery/packet.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Chunks that have arrived, in any order, until their windows are complete.
class ChunkBuffer {
public:
	/// Chunks beyond the next one that are kept.
	static constexpr uint8_t AHEAD = 128;

	/// Forgets all; the next chunk will be `next`.
	void restart(uint8_t next);
	/// Before `restart` all chunks are kept, as nobody knows which is the next.
	void forget();
	/// False if it is known already, too far ahead, or short before `restart`. `number` becomes all 8 bits of its number.
	bool add(const ChunkItem &chunk, uint8_t &number);
	/// Puts the next window together if all of it is there, and moves on behind it. `check` is that of its last
	/// chunk, of which `check_mask` has the bits that were sent.
	bool take_window(std::vector<uint8_t> &window, uint8_t &check, uint8_t &check_mask);
	/// True if the next chunks are no window: they do not begin with a first one, or a first one comes before a last.
	[[nodiscard]] bool is_broken() const { return _broken; }
	[[nodiscard]] AckItem ack() const;

private:
	struct Slot {
		bool full = false;
		bool first = false;
		bool last = false;
		uint8_t check = 0;
		uint8_t check_mask = 0;
		std::vector<uint8_t> bytes;
	};

	[[nodiscard]] uint8_t first_missing() const;
	/// Takes what is in a slot out, and keeps its memory for the next chunk.
	void empty(Slot &slot);

	std::array<Slot, 256> _slots;
	std::vector<std::vector<uint8_t>> _spare;
	uint8_t _next = 0; // the first chunk of the next window
	bool _started = false;
	bool _broken = false;
};

} // namespace net
