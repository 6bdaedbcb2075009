#pragma once

#include "net/delivery/packet.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// The last chunks of a stream, for retransmission, and the rate at which the stream grows.
class ChunkRing {
public:
	/// Bounds of the number of chunks kept. Within them, the ring keeps what its receivers still need.
	static constexpr uint32_t MIN_CHUNKS = 256;
	static constexpr uint32_t MAX_CHUNKS = 4096;

	struct Chunk {
		std::vector<uint8_t> bytes;
		bool first = false;
		bool last = false;
		uint8_t check = 0;
		uint64_t begin = 0; ///< bytes of all chunks before it, with their headers
	};

	/// Splits a window of `seconds` into chunks that fit into packets of `max_packet_size` bytes. Chunks before `oldest_needed` may be
	/// dropped.
	void push_window(const std::vector<uint8_t> &window, uint8_t check, double seconds, size_t max_packet_size, uint32_t oldest_needed) {
		// A packet must have room for a chunk of maximum size and a round-trip item.
		const size_t max_size = max_packet_size - CHUNK_HEADER - ROUND_TRIP_BYTES;
		const uint64_t before = _bytes;
		size_t at = 0;
		do {
			make_room(oldest_needed);
			Chunk &chunk = slot(_next++);
			const size_t size = std::min(max_size, window.size() - at);
			chunk.bytes.assign(window.begin() + ptrdiff_t(at), window.begin() + ptrdiff_t(at + size));
			chunk.first = at == 0;
			at += size;
			chunk.last = at == window.size();
			chunk.check = chunk.last ? check : 0;
			chunk.begin = _bytes;
			_oldest = std::max(_oldest, _next - std::min(_next, uint32_t(_chunks.size())));
			_bytes += CHUNK_HEADER + size;
		} while (at < window.size());
		if (seconds > 0.0) {
			const double weight = std::min(seconds / RATE_TIME, 1.0);
			_rate += (double(_bytes - before) / seconds - _rate) * weight;
		}
	}
	/// A chunk from oldest() to next() - 1.
	[[nodiscard]] const Chunk &chunk(uint32_t number) const { return _chunks[number & (uint32_t(_chunks.size()) - 1)]; }
	[[nodiscard]] uint32_t oldest() const { return _oldest; }
	/// The number of the next chunk.
	[[nodiscard]] uint32_t next() const { return _next; }
	/// Bytes of the chunks from `number` on, with their headers.
	[[nodiscard]] size_t bytes_from(uint32_t number) const { return number < _next ? size_t(_bytes - chunk(std::max(number, oldest())).begin) : 0; }
	/// Bytes per second of the stream, averaged over RATE_TIME.
	[[nodiscard]] double rate() const { return _rate; }

private:
	static constexpr double RATE_TIME = 0.3; // seconds

	[[nodiscard]] Chunk &slot(uint32_t number) { return _chunks[number & (uint32_t(_chunks.size()) - 1)]; }
	void make_room(uint32_t oldest_needed) {
		if (_next - std::min(oldest_needed, _next) < _chunks.size() || _chunks.size() == MAX_CHUNKS) {
			return;
		}
		std::vector<Chunk> chunks(2 * _chunks.size());
		for (uint32_t number = oldest(); number < _next; ++number) {
			std::swap(chunks[number & (uint32_t(chunks.size()) - 1)], slot(number));
		}
		_chunks.swap(chunks);
	}

	std::vector<Chunk> _chunks = std::vector<Chunk>(MIN_CHUNKS); // by number, modulo their count, which is a power of two
	uint32_t _next = 0;
	uint32_t _oldest = 0;
	uint64_t _bytes = 0; // of all chunks so far, with their headers
	double _rate = 0.0;
};

} // namespace net
