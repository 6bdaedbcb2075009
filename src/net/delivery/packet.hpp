#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// The items of a packet; docs/wire-format.md describes them byte by byte.

namespace net {

/// Of the format of streams; a receiver of another one says so.
inline constexpr uint8_t STREAM_VERSION = 1;

/// A piece of a window, numbered in the order of the stream.
struct ChunkItem {
	/// A short chunk is less than this behind or ahead of the first one that its receiver lacks.
	static constexpr uint8_t SHORT_REACH = 8;

	uint8_t number = 0; ///< the low 8 bits; of a short one the low 4
	bool first = false; ///< of its window
	bool last = false; ///< of its window
	uint8_t check = 0; ///< of the state after the window, 8 bits; of a short one the low 3; 0 but in the last chunk
	const uint8_t *bytes = nullptr;
	size_t size = 0;
	bool is_short = false; ///< a whole window, in the form with a header of one byte and 3 bits of the check
};

/// A piece of a whole state.
struct StatePartItem {
	uint8_t state = 0; ///< number of the state
	uint8_t next_chunk = 0; ///< the first chunk after it
	uint16_t part = 0;
	uint16_t parts = 0;
	const uint8_t *bytes = nullptr;
	size_t size = 0;
};

/// Which chunks have arrived: all before `next`, not `next`, and of those after it the ones whose bits are set.
struct AckItem {
	uint8_t next = 0;
	uint64_t later = 0;
};

/// Which parts of a state have arrived, likewise.
struct StateAckItem {
	uint8_t state = 0;
	uint16_t next = 0;
	uint32_t later = 0;
};

/// What a packet holds. Pointers lead into the packet.
struct PacketContent {
	std::vector<ChunkItem> chunks;
	std::vector<StatePartItem> parts;
	std::vector<AckItem> acks;
	std::vector<StateAckItem> state_acks;
	bool wants_state = false;
	double round_trip = 0.0; ///< seconds; 0 if it is not told
};

/// Largest number of bytes that the header of a chunk, of a state's part takes.
inline constexpr size_t CHUNK_HEADER = 5;
inline constexpr size_t STATE_PART_HEADER = 9;
/// What the item of a round trip takes.
inline constexpr size_t ROUND_TRIP_BYTES = 3;

/// Appends an item. A chunk that is the packet's last item leaves its length out, and may be short.
void put_chunk(std::vector<uint8_t> &packet, const ChunkItem &chunk, bool is_last_item);
void put_state_part(std::vector<uint8_t> &packet, const StatePartItem &part);
void put_ack(std::vector<uint8_t> &packet, const AckItem &ack);
void put_state_ack(std::vector<uint8_t> &packet, const StateAckItem &ack);
void put_state_wish(std::vector<uint8_t> &packet);
void put_round_trip(std::vector<uint8_t> &packet, double seconds);

/// Reads all of a packet. Null, or what is wrong with it (a literal).
const char *read_packet(const uint8_t *packet, size_t size, PacketContent &content);

} // namespace net
