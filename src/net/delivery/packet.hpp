#pragma once

#include "net/stream/packet_error.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// The items of a packet; docs/wire-format.md describes them byte by byte.

namespace net {

/// A piece of a window. Chunks are numbered in the order of the stream.
struct ChunkItem {
	/// Maximum distance (exclusive) of a chunk in short form, and of one that is neither short nor wide, from the receiver's first
	/// missing chunk.
	static constexpr uint16_t SHORT_REACH = 8;
	static constexpr uint16_t NARROW_REACH = 128;

	uint16_t number = 0; ///< the low 16 bits if wide, 4 in the short form, otherwise 8
	bool first = false; ///< first chunk of its window
	bool last = false; ///< last chunk of its window
	uint8_t check = 0; ///< checksum of the state after the window: 8 bits, or 3 in the short form; 0 except in the last chunk
	const uint8_t *bytes = nullptr;
	size_t size = 0;
	bool is_short = false; ///< a whole window with a one-byte header
	bool is_wide = false; ///< has 16 bits of its number
};

/// A piece of a snapshot.
struct FragmentItem {
	uint8_t snapshot = 0; ///< number of the snapshot
	uint16_t next_chunk = 0; ///< the first chunk after the snapshot, 16 bits
	uint16_t index = 0;
	uint16_t count = 0; ///< number of fragments in the snapshot
	const uint8_t *bytes = nullptr;
	size_t size = 0;
};

/// What has arrived after the first missing number: runs of missing numbers, each followed by a run of present ones. (As the ranges
/// of QUIC's acknowledgements, RFC 9000, section 19.3.1, but the oldest first.)
class AckRuns {
public:
	struct Run {
		uint16_t missing = 0; ///< at least 1
		uint16_t present = 0; ///< at least 1
	};
	static constexpr size_t MAX_RUNS = 64;

	/// Appends a run. Does nothing if there are MAX_RUNS: later numbers then count as missing.
	void add(uint16_t missing, uint16_t present) {
		if (_count < MAX_RUNS) {
			_runs[_count++] = { missing, present };
		}
	}
	[[nodiscard]] size_t size() const { return _count; }
	[[nodiscard]] const Run &operator[](size_t index) const { return _runs[index]; }
	/// Calls visit(begin, end) for each range of present numbers, relative to the first missing number, in ascending order.
	template <class Visit>
	void visit(Visit &&visit) const {
		uint32_t at = 0;
		for (size_t i = 0; i < _count; ++i) {
			at += _runs[i].missing;
			visit(at, at + _runs[i].present);
			at += _runs[i].present;
		}
	}

private:
	std::array<Run, MAX_RUNS> _runs;
	size_t _count = 0;
};

/// Selective acknowledgement: all chunks before `next` have arrived, `next` has not, and of the later ones those in `later`.
struct AckItem {
	uint16_t next = 0;
	uint8_t packets = 0; ///< number of packets received, modulo 256
	AckRuns later;
};

/// Selective acknowledgement of a snapshot's fragments, in the same form.
struct SnapshotAckItem {
	uint8_t snapshot = 0;
	uint16_t next = 0;
	AckRuns later;
};

/// A receiver's request to align the ends of windows, so that windows of several senders arrive together.
struct AlignItem {
	uint8_t number = 0; ///< of the request: a repeated one has the same
	double period = 0.0; ///< seconds between two instants at which windows should end
	double shift = 0.0; ///< seconds by which windows should end later
};

/// The items of one packet. Pointers point into the packet's bytes.
struct PacketContent {
	/// Receivers send one acknowledgement of each kind in a packet.
	static constexpr size_t MAX_ACKS = 8;

	std::vector<ChunkItem> chunks;
	std::vector<FragmentItem> fragments;
	std::vector<AckItem> acks; ///< the first MAX_ACKS
	std::vector<SnapshotAckItem> snapshot_acks; ///< the first MAX_ACKS
	bool requests_snapshot = false;
	std::optional<AlignItem> alignment;
	double round_trip = 0.0; ///< seconds; 0 if the packet does not contain it
	size_t ack_count = 0; ///< number of all acknowledgements, including those left out
};

/// Maximum size of the header of a chunk and of a fragment, in bytes.
inline constexpr size_t CHUNK_HEADER = 6;
inline constexpr size_t FRAGMENT_HEADER = 10;
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
