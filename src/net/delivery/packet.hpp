#pragma once

#include "net/stream/packet_error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// The items of a packet; docs/wire-format.md describes them byte by byte.

namespace net {

/// A piece of a window. Chunks are numbered in the order of the stream.
struct ChunkItem {
	/// Maximum distance (exclusive) of a chunk in short form from the receiver's first missing chunk.
	static constexpr uint8_t SHORT_REACH = 8;

	uint8_t number = 0; ///< the low 8 bits; in the short form the low 4
	bool first = false; ///< first chunk of its window
	bool last = false; ///< last chunk of its window
	uint8_t check = 0; ///< checksum of the state after the window: 8 bits, or 3 in the short form; 0 except in the last chunk
	const uint8_t *bytes = nullptr;
	size_t size = 0;
	bool is_short = false; ///< a whole window with a one-byte header
};

/// A piece of a snapshot.
struct FragmentItem {
	uint8_t snapshot = 0; ///< number of the snapshot
	uint8_t next_chunk = 0; ///< the first chunk after the snapshot
	uint16_t index = 0;
	uint16_t count = 0; ///< number of fragments in the snapshot
	const uint8_t *bytes = nullptr;
	size_t size = 0;
};

/// Selective acknowledgement: chunks before `next` have arrived, `next` has not; bit i of `later` stands for next + 1 + i.
struct AckItem {
	uint8_t next = 0;
	uint64_t later = 0;
	uint8_t packets = 0; ///< number of packets received, modulo 256
};

/// Selective acknowledgement of a snapshot's fragments, in the same form.
struct SnapshotAckItem {
	uint8_t snapshot = 0;
	uint16_t next = 0;
	uint32_t later = 0;
};

/// A receiver's request to align the ends of windows, so that windows of several senders arrive together.
struct AlignItem {
	uint8_t number = 0; ///< of the request: a repeated one has the same
	double period = 0.0; ///< seconds between two instants at which windows should end
	double shift = 0.0; ///< seconds by which windows should end later
};

/// The items of one packet. Pointers point into the packet's bytes.
struct PacketContent {
	std::vector<ChunkItem> chunks;
	std::vector<FragmentItem> fragments;
	std::vector<AckItem> acks;
	std::vector<SnapshotAckItem> snapshot_acks;
	bool requests_snapshot = false;
	std::optional<AlignItem> alignment;
	double round_trip = 0.0; ///< seconds; 0 if the packet does not contain it
};

/// Maximum size of the header of a chunk and of a fragment, in bytes.
inline constexpr size_t CHUNK_HEADER = 5;
inline constexpr size_t FRAGMENT_HEADER = 9;
/// Size of a round-trip item, in bytes.
inline constexpr size_t ROUND_TRIP_BYTES = 3;

/// These append an item. Only the last chunk of a packet omits its length, and only that chunk may be short.
void put_chunk(std::vector<uint8_t> &packet, const ChunkItem &chunk, bool is_last_item);
void put_fragment(std::vector<uint8_t> &packet, const FragmentItem &fragment);
void put_ack(std::vector<uint8_t> &packet, const AckItem &ack);
void put_snapshot_ack(std::vector<uint8_t> &packet, const SnapshotAckItem &ack);
void put_snapshot_request(std::vector<uint8_t> &packet);
void put_alignment(std::vector<uint8_t> &packet, const AlignItem &alignment);
void put_round_trip(std::vector<uint8_t> &packet, double seconds);

/// Parses a whole packet into `content`, whose memory is reused. Fails with the reason.
PacketResult read_packet(const uint8_t *packet, size_t size, PacketContent &content);

} // namespace net
