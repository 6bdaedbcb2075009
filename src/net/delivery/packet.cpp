#include "net/delivery/packet.hpp"

#include "net/stream/stream_settings.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

// First byte of an item: short chunk 0 check(3) number(4); chunk 10 first last has-length 000; others 11.
constexpr uint8_t SHORT_CHUNK_BELOW = 0x80;
constexpr uint8_t CHUNK = 0x80;
constexpr uint8_t CHUNK_FIRST = 0x20;
constexpr uint8_t CHUNK_LAST = 0x10;
constexpr uint8_t CHUNK_LENGTH = 0x08;
constexpr uint8_t CHUNK_BELOW = 0xc0;
constexpr uint8_t FRAGMENT = 0xe0;
constexpr uint8_t ROUND_TRIP = 0xe1;
constexpr uint8_t ACK = 0xc0;
constexpr uint8_t ACK_WITH_LATER = 0xc1;
constexpr uint8_t SNAPSHOT_REQUEST = 0xc2;
constexpr uint8_t SNAPSHOT_ACK = 0xc3;

constexpr double ROUND_TRIP_STEPS = 10000.0; // per second

void put(std::vector<uint8_t> &packet, uint64_t value, int bytes) {
	for (int i = 0; i < bytes; ++i) {
		packet.push_back(uint8_t(value >> (8 * i)));
	}
}

/// Reads little-endian numbers. Past the end, reads return 0 and `failed()` stays true.
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

void read_fragment(ByteReader &reader, PacketContent &content) {
	FragmentItem fragment;
	fragment.snapshot = uint8_t(reader.number(1));
	fragment.next_chunk = uint8_t(reader.number(1));
	fragment.index = uint16_t(reader.number(2));
	fragment.count = uint16_t(reader.number(2));
	fragment.size = size_t(reader.number(2));
	fragment.bytes = reader.take(fragment.size);
	content.fragments.push_back(fragment);
}

void read_snapshot_ack(ByteReader &reader, PacketContent &content) {
	SnapshotAckItem ack;
	ack.snapshot = uint8_t(reader.number(1));
	ack.next = uint16_t(reader.number(2));
	ack.later = uint32_t(reader.number(4));
	content.snapshot_acks.push_back(ack);
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

void put_fragment(std::vector<uint8_t> &packet, const FragmentItem &fragment) {
	packet.push_back(FRAGMENT);
	packet.push_back(fragment.snapshot);
	packet.push_back(fragment.next_chunk);
	put(packet, fragment.index, 2);
	put(packet, fragment.count, 2);
	put(packet, fragment.size, 2);
	packet.insert(packet.end(), fragment.bytes, fragment.bytes + fragment.size);
}

void put_ack(std::vector<uint8_t> &packet, const AckItem &ack) {
	packet.push_back(ack.later != 0 ? ACK_WITH_LATER : ACK);
	packet.push_back(ack.next);
	if (ack.later != 0) {
		// Omit leading zero bytes.
		int bytes = 0;
		while (bytes < 8 && (ack.later >> (8 * bytes)) != 0) {
			++bytes;
		}
		packet.push_back(uint8_t(bytes));
		put(packet, ack.later, bytes);
	}
}

void put_snapshot_ack(std::vector<uint8_t> &packet, const SnapshotAckItem &ack) {
	packet.push_back(SNAPSHOT_ACK);
	packet.push_back(ack.snapshot);
	put(packet, ack.next, 2);
	put(packet, ack.later, 4);
}

void put_snapshot_request(std::vector<uint8_t> &packet) {
	packet.push_back(SNAPSHOT_REQUEST);
}

void put_round_trip(std::vector<uint8_t> &packet, double seconds) {
	packet.push_back(ROUND_TRIP);
	put(packet, uint64_t(std::lround(std::clamp(seconds * ROUND_TRIP_STEPS, 1.0, 65535.0))), 2);
}

PacketResult read_packet(const uint8_t *packet, size_t size, PacketContent &content) {
	content.chunks.clear();
	content.fragments.clear();
	content.acks.clear();
	content.snapshot_acks.clear();
	content.requests_snapshot = false;
	content.round_trip = 0.0;
	if (size == 0) {
		return PacketError::EMPTY;
	}
	if (size > size_t(MAX_PACKET_BYTES)) {
		return PacketError::TOO_LONG;
	}
	ByteReader reader(packet, size);
	while (reader.left() > 0) {
		const uint8_t kind = uint8_t(reader.number(1));
		if (kind < SHORT_CHUNK_BELOW || (kind < CHUNK_BELOW && (kind & 7) == 0)) {
			read_chunk(reader, kind, content);
		} else if (kind == FRAGMENT) {
			read_fragment(reader, content);
		} else if (kind == ROUND_TRIP) {
			content.round_trip = double(reader.number(2)) / ROUND_TRIP_STEPS;
		} else if (kind == ACK || kind == ACK_WITH_LATER) {
			AckItem ack;
			ack.next = uint8_t(reader.number(1));
			if (kind == ACK_WITH_LATER) {
				const uint64_t bytes = reader.number(1);
				if (bytes < 1 || bytes > 8) {
					return PacketError::BAD_ACK;
				}
				ack.later = reader.number(int(bytes));
			}
			content.acks.push_back(ack);
		} else if (kind == SNAPSHOT_REQUEST) {
			content.requests_snapshot = true;
		} else if (kind == SNAPSHOT_ACK) {
			read_snapshot_ack(reader, content);
		} else {
			return PacketError::UNKNOWN_ITEM;
		}
		if (reader.failed()) {
			return PacketError::TRUNCATED;
		}
	}
	return {};
}

} // namespace net
