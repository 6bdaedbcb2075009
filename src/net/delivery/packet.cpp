#include "net/delivery/packet.hpp"

#include "net/coding/bit_stream.hpp"
#include "net/coding/byte_stream.hpp"
#include "net/stream/stream_settings.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

// First byte of an item: short chunk 0 check(3) number(4); chunk 10 first last has-length wide 00; others 11.
constexpr uint8_t SHORT_CHUNK_BELOW = 0x80;
constexpr uint8_t CHUNK = 0x80;
constexpr uint8_t CHUNK_FIRST = 0x20;
constexpr uint8_t CHUNK_LAST = 0x10;
constexpr uint8_t CHUNK_LENGTH = 0x08;
constexpr uint8_t CHUNK_WIDE = 0x04;
constexpr uint8_t CHUNK_RESERVED = 0x03;
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
		chunk.is_wide = (kind & CHUNK_WIDE) != 0;
		chunk.number = chunk.is_wide ? reader.read<uint16_t>() : reader.read<uint8_t>();
		chunk.check = chunk.last ? reader.read<uint8_t>() : 0;
		chunk.size = (kind & CHUNK_LENGTH) != 0 ? reader.read<uint16_t>() : reader.left();
	}
	chunk.bytes = reader.take(chunk.size);
	content.chunks.push_back(chunk);
}

void read_fragment(ByteReader &reader, PacketContent &content) {
	FragmentItem fragment{ reader.read<uint8_t>(), reader.read<uint16_t>(), reader.read<uint16_t>(), reader.read<uint16_t>() };
	fragment.size = reader.read<uint16_t>();
	fragment.bytes = reader.take(fragment.size);
	content.fragments.push_back(fragment);
}

/// Numbers of 7 bits in each byte, the lowest first; bit 7: more follow.
void put_count(std::vector<uint8_t> &packet, uint16_t count) {
	uint32_t rest = count;
	for (; rest >= 0x80; rest >>= 7) {
		packet.push_back(uint8_t(rest | 0x80));
	}
	packet.push_back(uint8_t(rest));
}

/// Returns 0 if it exceeds 16 bits.
uint16_t read_count(ByteReader &reader) {
	uint32_t count = 0;
	for (int shift = 0; shift < 21; shift += 7) {
		const auto byte = reader.read<uint8_t>();
		count |= uint32_t(byte & 0x7f) << shift;
		if ((byte & 0x80) == 0) {
			return count <= 0xffff ? uint16_t(count) : 0;
		}
	}
	return 0;
}

void put_runs(std::vector<uint8_t> &packet, const AckRuns &runs) {
	packet.push_back(uint8_t(runs.size()));
	for (size_t i = 0; i < runs.size(); ++i) {
		put_count(packet, runs[i].missing);
		put_count(packet, runs[i].present);
	}
}

/// Returns false if a run is empty or there are too many.
bool read_runs(ByteReader &reader, AckRuns &runs) {
	const size_t count = reader.read<uint8_t>();
	uint32_t total = 0;
	for (size_t i = 0; i < count && count <= AckRuns::MAX_RUNS && !reader.failed(); ++i) {
		const uint16_t missing = read_count(reader);
		const uint16_t present = read_count(reader);
		total += uint32_t(missing) + present;
		if (!reader.failed() && (missing == 0 || present == 0 || total > 0xffff)) {
			return false;
		}
		runs.add(missing, present);
	}
	return count <= AckRuns::MAX_RUNS;
}

} // namespace

void put_chunk(std::vector<uint8_t> &packet, const ChunkItem &chunk, bool is_last_item) {
	if (chunk.is_short && is_last_item) {
		packet.push_back(uint8_t((chunk.check & 7) << 4 | (chunk.number & 15)));
	} else {
		packet.push_back(uint8_t(CHUNK | (chunk.first ? CHUNK_FIRST : 0) | (chunk.last ? CHUNK_LAST : 0) | (is_last_item ? 0 : CHUNK_LENGTH) | (chunk.is_wide ? CHUNK_WIDE : 0)));
		packet.push_back(uint8_t(chunk.number));
		if (chunk.is_wide) {
			packet.push_back(uint8_t(chunk.number >> 8));
		}
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
	packet.insert(packet.end(), { FRAGMENT, fragment.snapshot });
	put_number(packet, fragment.next_chunk);
	put_number(packet, fragment.index);
	put_number(packet, fragment.count);
	put_number(packet, uint16_t(fragment.size));
	packet.insert(packet.end(), fragment.bytes, fragment.bytes + fragment.size);
}

void put_ack(std::vector<uint8_t> &packet, const AckItem &ack) {
	packet.push_back(ack.later.size() > 0 ? ACK_WITH_LATER : ACK);
	put_number(packet, ack.next);
	packet.push_back(ack.packets);
	if (ack.later.size() > 0) {
		put_runs(packet, ack.later);
	}
}

void put_snapshot_ack(std::vector<uint8_t> &packet, const SnapshotAckItem &ack) {
	packet.insert(packet.end(), { SNAPSHOT_ACK, ack.snapshot });
	put_number(packet, ack.next);
	put_runs(packet, ack.later);
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
	content.ack_count = 0;
	if (size == 0) {
		return PacketError::EMPTY;
	}
	if (size > StreamSettings::MAX_PACKET_SIZE) {
		return PacketError::TOO_LONG;
	}
	ByteReader reader(packet, size);
	while (reader.left() > 0) {
		const auto kind = reader.read<uint8_t>();
		if (kind < SHORT_CHUNK_BELOW || (kind < CHUNK_BELOW && (kind & CHUNK_RESERVED) == 0)) {
			read_chunk(reader, kind, content);
		} else if (kind == FRAGMENT) {
			read_fragment(reader, content);
		} else if (kind == ROUND_TRIP) {
			content.round_trip = double(reader.read<uint16_t>()) / ROUND_TRIP_STEPS;
		} else if (kind == ACK || kind == ACK_WITH_LATER) {
			AckItem ack;
			ack.next = reader.read<uint16_t>();
			ack.packets = reader.read<uint8_t>();
			if (kind == ACK_WITH_LATER && !read_runs(reader, ack.later)) {
				return PacketError::BAD_ACK;
			}
			++content.ack_count;
			if (content.acks.size() < PacketContent::MAX_ACKS) {
				content.acks.push_back(ack);
			}
		} else if (kind == SNAPSHOT_REQUEST) {
			content.requests_snapshot = true;
		} else if (kind == ALIGN) {
			AlignItem alignment{ reader.read<uint8_t>() };
			alignment.period = double(reader.read<uint32_t>()) / PERIOD_STEPS;
			alignment.shift = double(reader.read<int16_t>()) / SHIFT_STEPS;
			content.alignment = alignment;
		} else if (kind == SNAPSHOT_ACK) {
			SnapshotAckItem ack{ reader.read<uint8_t>(), reader.read<uint16_t>(), {} };
			if (!read_runs(reader, ack.later)) {
				return PacketError::BAD_ACK;
			}
			++content.ack_count;
			if (content.snapshot_acks.size() < PacketContent::MAX_ACKS) {
				content.snapshot_acks.push_back(ack);
			}
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
