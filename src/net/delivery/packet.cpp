#include "net/delivery/packet.hpp"

#include "net/stream_settings.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

// First bytes. A short chunk is 0 check(3) number(4), a chunk 10 first last length-follows 000, everything else 11.
constexpr uint8_t SHORT_CHUNK_BELOW = 0x80;
constexpr uint8_t CHUNK = 0x80;
constexpr uint8_t CHUNK_FIRST = 0x20;
constexpr uint8_t CHUNK_LAST = 0x10;
constexpr uint8_t CHUNK_LENGTH = 0x08;
constexpr uint8_t CHUNK_BELOW = 0xc0;
constexpr uint8_t STATE_PART = 0xe0;
constexpr uint8_t ROUND_TRIP = 0xe1;
constexpr uint8_t ACK = 0xc0;
constexpr uint8_t ACK_WITH_LATER = 0xc1;
constexpr uint8_t STATE_WISH = 0xc2;
constexpr uint8_t STATE_ACK = 0xc3;

constexpr double ROUND_TRIP_STEPS = 10000.0; // a second

void put(std::vector<uint8_t> &packet, uint64_t value, int bytes) {
	for (int i = 0; i < bytes; ++i) {
		packet.push_back(uint8_t(value >> (8 * i)));
	}
}

/// Reads little endian numbers; past the end zeros, and it stays failed.
class ByteReader {
public:
	ByteReader(const uint8_t *bytes, size_t size) :
			_bytes(bytes), _size(size) {}

	uint64_t number(int bytes) {
		uint64_t value = 0;
		const uint8_t *from = take(size_t(bytes));
		for (int i = 0; from != nullptr && i < bytes; ++i) {
			value |= uint64_t(from[i]) << (8 * i);
		}
		return value;
	}

	const uint8_t *take(size_t count) {
		if (count > _size - _at) {
			_failed = true;
			_at = _size;
			return nullptr;
		}
		_at += count;
		return _bytes + _at - count;
	}

	[[nodiscard]] size_t left() const { return _size - _at; }
	[[nodiscard]] bool failed() const { return _failed; }

private:
	const uint8_t *_bytes;
	size_t _size;
	size_t _at = 0;
	bool _failed = false;
};

void read_chunk(ByteReader &reader, uint8_t kind, PacketContent &content) {
	ChunkItem chunk;
	if (kind < SHORT_CHUNK_BELOW) {
		chunk.is_short = chunk.first = chunk.last = true;
		chunk.check = kind >> 4;
		chunk.number = kind & 15;
		chunk.size = reader.left();
	} else {
		chunk.first = (kind & CHUNK_FIRST) != 0;
		chunk.last = (kind & CHUNK_LAST) != 0;
		chunk.number = uint8_t(reader.number(1));
		chunk.check = chunk.last ? uint8_t(reader.number(1)) : 0;
		chunk.size = (kind & CHUNK_LENGTH) != 0 ? size_t(reader.number(2)) : reader.left();
	}
	chunk.bytes = reader.take(chunk.size);
	content.chunks.push_back(chunk);
}

void read_state_part(ByteReader &reader, PacketContent &content) {
	StatePartItem part;
	part.state = uint8_t(reader.number(1));
	part.next_chunk = uint8_t(reader.number(1));
	part.part = uint16_t(reader.number(2));
	part.parts = uint16_t(reader.number(2));
	part.size = size_t(reader.number(2));
	part.bytes = reader.take(part.size);
	content.parts.push_back(part);
}

void read_state_ack(ByteReader &reader, PacketContent &content) {
	StateAckItem ack;
	ack.state = uint8_t(reader.number(1));
	ack.next = uint16_t(reader.number(2));
	ack.later = uint32_t(reader.number(4));
	content.state_acks.push_back(ack);
}

} // namespace

void put_chunk(std::vector<uint8_t> &packet, const ChunkItem &chunk, bool is_last_item) {
	if (chunk.is_short && is_last_item) {
		packet.push_back(uint8_t((chunk.check & 7) << 4 | (chunk.number & 15)));
	} else {
		packet.push_back(uint8_t(CHUNK | (chunk.first ? CHUNK_FIRST : 0) | (chunk.last ? CHUNK_LAST : 0) | (is_last_item ? 0 : CHUNK_LENGTH)));
		packet.push_back(chunk.number);
		if (chunk.last) {
			packet.push_back(chunk.check);
		}
		if (!is_last_item) {
			put(packet, chunk.size, 2);
		}
	}
	packet.insert(packet.end(), chunk.bytes, chunk.bytes + chunk.size);
}

void put_state_part(std::vector<uint8_t> &packet, const StatePartItem &part) {
	packet.push_back(STATE_PART);
	packet.push_back(part.state);
	packet.push_back(part.next_chunk);
	put(packet, part.part, 2);
	put(packet, part.parts, 2);
	put(packet, part.size, 2);
	packet.insert(packet.end(), part.bytes, part.bytes + part.size);
}

void put_ack(std::vector<uint8_t> &packet, const AckItem &ack) {
	packet.push_back(ack.later != 0 ? ACK_WITH_LATER : ACK);
	packet.push_back(ack.next);
	if (ack.later != 0) {
		// As many bytes as the highest bit needs.
		int bytes = 0;
		while (bytes < 8 && (ack.later >> (8 * bytes)) != 0) {
			++bytes;
		}
		packet.push_back(uint8_t(bytes));
		put(packet, ack.later, bytes);
	}
}

void put_state_ack(std::vector<uint8_t> &packet, const StateAckItem &ack) {
	packet.push_back(STATE_ACK);
	packet.push_back(ack.state);
	put(packet, ack.next, 2);
	put(packet, ack.later, 4);
}

void put_state_wish(std::vector<uint8_t> &packet) {
	packet.push_back(STATE_WISH);
}

void put_round_trip(std::vector<uint8_t> &packet, double seconds) {
	packet.push_back(ROUND_TRIP);
	put(packet, uint64_t(std::lround(std::clamp(seconds * ROUND_TRIP_STEPS, 1.0, 65535.0))), 2);
}

const char *read_packet(const uint8_t *packet, size_t size, PacketContent &content) {
	content.chunks.clear();
	content.parts.clear();
	content.acks.clear();
	content.state_acks.clear();
	content.wants_state = false;
	content.round_trip = 0.0;
	if (size == 0) {
		return "the packet is empty";
	}
	if (size > size_t(MAX_PACKET_BYTES)) {
		return "the packet is longer than any that is sent";
	}
	ByteReader reader(packet, size);
	while (reader.left() > 0) {
		const uint8_t kind = uint8_t(reader.number(1));
		if (kind < SHORT_CHUNK_BELOW || (kind < CHUNK_BELOW && (kind & 7) == 0)) {
			read_chunk(reader, kind, content);
		} else if (kind == STATE_PART) {
			read_state_part(reader, content);
		} else if (kind == ROUND_TRIP) {
			content.round_trip = double(reader.number(2)) / ROUND_TRIP_STEPS;
		} else if (kind == ACK || kind == ACK_WITH_LATER) {
			AckItem ack;
			ack.next = uint8_t(reader.number(1));
			if (kind == ACK_WITH_LATER) {
				const uint64_t bytes = reader.number(1);
				if (bytes < 1 || bytes > 8) {
					return "the packet's list of what arrived is of a wrong length";
				}
				ack.later = reader.number(int(bytes));
			}
			content.acks.push_back(ack);
		} else if (kind == STATE_WISH) {
			content.wants_state = true;
		} else if (kind == STATE_ACK) {
			read_state_ack(reader, content);
		} else {
			return "the packet holds something of an unknown kind";
		}
		if (reader.failed()) {
			return "the packet is cut off";
		}
	}
	return nullptr;
}

} // namespace net
