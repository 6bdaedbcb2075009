#include "net/delivery/packet.hpp"

#include "net/coding/bit_stream.hpp"
#include "net/coding/byte_stream.hpp"
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
constexpr uint8_t ALIGN = 0xc4;

constexpr double ROUND_TRIP_STEPS = 10000.0; // per second
constexpr double PERIOD_STEPS = 1e6; // per second
constexpr double SHIFT_STEPS = 10000.0; // per second

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
		chunk.number = reader.read<uint8_t>();
		chunk.check = chunk.last ? reader.read<uint8_t>() : 0;
		chunk.size = (kind & CHUNK_LENGTH) != 0 ? reader.read<uint16_t>() : reader.left();
	}
	chunk.bytes = reader.take(chunk.size);
	content.chunks.push_back(chunk);
}

void read_fragment(ByteReader &reader, PacketContent &content) {
	FragmentItem fragment{ reader.read<uint8_t>(), reader.read<uint8_t>(), reader.read<uint16_t>(), reader.read<uint16_t>() };
	fragment.size = reader.read<uint16_t>();
	fragment.bytes = reader.take(fragment.size);
	content.fragments.push_back(fragment);
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
			put_number(packet, uint16_t(chunk.size));
		}
	}
	packet.insert(packet.end(), chunk.bytes, chunk.bytes + chunk.size);
}

void put_fragment(std::vector<uint8_t> &packet, const FragmentItem &fragment) {
	packet.insert(packet.end(), { FRAGMENT, fragment.snapshot, fragment.next_chunk });
	put_number(packet, fragment.index);
	put_number(packet, fragment.count);
	put_number(packet, uint16_t(fragment.size));
	packet.insert(packet.end(), fragment.bytes, fragment.bytes + fragment.size);
}

void put_ack(std::vector<uint8_t> &packet, const AckItem &ack) {
	packet.insert(packet.end(), { ack.later != 0 ? ACK_WITH_LATER : ACK, ack.next, ack.packets });
	if (ack.later != 0) {
		packet.push_back(uint8_t((bit_width(ack.later) + 7) / 8));
	}
	for (uint64_t rest = ack.later; rest != 0; rest >>= 8) {
		packet.push_back(uint8_t(rest));
	}
}

void put_snapshot_ack(std::vector<uint8_t> &packet, const SnapshotAckItem &ack) {
	packet.insert(packet.end(), { SNAPSHOT_ACK, ack.snapshot });
	put_number(packet, ack.next);
	put_number(packet, ack.later);
}

void put_snapshot_request(std::vector<uint8_t> &packet) {
	packet.push_back(SNAPSHOT_REQUEST);
}

void put_alignment(std::vector<uint8_t> &packet, const AlignItem &alignment) {
	packet.insert(packet.end(), { ALIGN, alignment.number });
	put_number(packet, uint32_t(std::lround(std::clamp(alignment.period * PERIOD_STEPS, 1.0, 1e9))));
	put_number(packet, int16_t(std::lround(std::clamp(alignment.shift * SHIFT_STEPS, -32767.0, 32767.0))));
}

void put_round_trip(std::vector<uint8_t> &packet, double seconds) {
	packet.push_back(ROUND_TRIP);
	put_number(packet, uint16_t(std::lround(std::clamp(seconds * ROUND_TRIP_STEPS, 1.0, 65535.0))));
}

PacketResult read_packet(const uint8_t *packet, size_t size, PacketContent &content) {
	content.chunks.clear();
	content.fragments.clear();
	content.acks.clear();
	content.snapshot_acks.clear();
	content.requests_snapshot = false;
	content.alignment.reset();
	content.round_trip = 0.0;
	if (size == 0) {
		return PacketError::EMPTY;
	}
	if (size > StreamSettings::MAX_PACKET_SIZE) {
		return PacketError::TOO_LONG;
	}
	ByteReader reader(packet, size);
	while (reader.left() > 0) {
		const auto kind = reader.read<uint8_t>();
		if (kind < SHORT_CHUNK_BELOW || (kind < CHUNK_BELOW && (kind & 7) == 0)) {
			read_chunk(reader, kind, content);
		} else if (kind == FRAGMENT) {
			read_fragment(reader, content);
		} else if (kind == ROUND_TRIP) {
			content.round_trip = double(reader.read<uint16_t>()) / ROUND_TRIP_STEPS;
		} else if (kind == ACK || kind == ACK_WITH_LATER) {
			AckItem ack;
			ack.next = reader.read<uint8_t>();
			ack.packets = reader.read<uint8_t>();
			if (kind == ACK_WITH_LATER) {
				const auto bytes = reader.read<uint8_t>();
				if (bytes < 1 || bytes > 8) {
					return PacketError::BAD_ACK;
				}
				ack.later = reader.read<uint64_t>(bytes);
			}
			content.acks.push_back(ack);
		} else if (kind == SNAPSHOT_REQUEST) {
			content.requests_snapshot = true;
		} else if (kind == ALIGN) {
			AlignItem alignment{ reader.read<uint8_t>() };
			alignment.period = double(reader.read<uint32_t>()) / PERIOD_STEPS;
			alignment.shift = double(reader.read<int16_t>()) / SHIFT_STEPS;
			content.alignment = alignment;
		} else if (kind == SNAPSHOT_ACK) {
			content.snapshot_acks.push_back({ reader.read<uint8_t>(), reader.read<uint16_t>(), reader.read<uint32_t>() });
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
