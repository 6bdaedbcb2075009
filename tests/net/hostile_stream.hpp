#pragma once

#include "net/delivery/fragment_buffer.hpp"
#include "net/stream/snapshot_header.hpp"
#include "net/stream/stream_encoder.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace net_test {

/// Builds packets of a stream that is coded as a sender codes it, but sends what no scene needs. Unlike a sender, it heeds nobody.
class HostileStream {
public:
	using Bytes = std::vector<uint8_t>;

	explicit HostileStream(uint32_t count, size_t packet_size = 1100) :
			_packet_size(packet_size) {
		replace_bodies(count);
	}

	/// The stream goes on with other bodies: only a snapshot tells receivers.
	void replace_bodies(uint32_t count) {
		_encoder = std::make_unique<net::StreamEncoder>(0.005f, 1.4f, cga::Mode::SEPARATE);
		for (uint32_t i = 0; i < count; ++i) {
			(void)_encoder->add_body(next_id++, tick, pose(i, 0.0));
		}
		_encoder->start_at(tick);
		_count = count;
	}
	void use_ids_from(uint32_t id) { next_id = id; }

	/// A snapshot with a new number.
	std::vector<Bytes> snapshot() {
		net::SnapshotHeader header;
		header.settings = settings;
		header.tick = uint64_t(tick);
		header.window = 0.1f;
		net::Snapshot snapshot;
		net::put_snapshot_header(snapshot.bytes, header);
		_encoder->encode_snapshot(snapshot.bytes);
		snapshot.fragment_size = _packet_size - net::FRAGMENT_HEADER;
		++_snapshot_number;
		std::vector<Bytes> packets;
		for (size_t i = 0; i < snapshot.fragment_count(); ++i) {
			const size_t begin = i * snapshot.fragment_size;
			packets.emplace_back();
			net::put_fragment(packets.back(), { _snapshot_number, _next_chunk, uint16_t(i), uint16_t(snapshot.fragment_count()), snapshot.bytes.data() + begin, std::min(snapshot.fragment_size, snapshot.bytes.size() - begin) });
		}
		return packets;
	}

	/// Appends a window to packets, several windows to each.
	void add_window(int ticks, std::vector<Bytes> &packets) {
		Bytes window;
		_encoder->encode_window(tick, ticks, window);
		tick += ticks;
		const size_t max_size = _packet_size - net::CHUNK_HEADER;
		for (size_t at = 0; at == 0 || at < window.size(); at += max_size) {
			const size_t size = std::min(max_size, window.size() - at);
			const bool is_last = at + size == window.size();
			if (packets.empty() || packets.back().size() + size + net::CHUNK_HEADER > _packet_size) {
				packets.emplace_back();
			}
			net::ChunkItem chunk;
			chunk.number = _next_chunk++;
			chunk.is_wide = true;
			chunk.first = at == 0;
			chunk.last = is_last;
			chunk.check = is_last ? _encoder->check() : 0;
			chunk.bytes = window.data() + at;
			chunk.size = size;
			net::put_chunk(packets.back(), chunk, false);
		}
	}

	/// All bodies move along noisy paths, which take many segments, or at constant velocity, which takes few bytes.
	void observe(int ticks, bool has_noise) {
		for (int i = 1; i <= ticks; ++i) {
			for (uint32_t body = 0; body < _count; ++body) {
				(void)_encoder->observe(next_id - _count + body, tick + i, pose(body, has_noise ? noise() : tick + i));
			}
		}
	}
	/// Removes all bodies and adds as many others.
	void exchange_bodies() {
		for (uint32_t i = 0; i < _count; ++i) {
			(void)_encoder->remove_body(next_id - _count + i, tick);
		}
		for (uint32_t i = 0; i < _count; ++i) {
			(void)_encoder->add_body(next_id++, tick, pose(i, 0.0));
		}
	}
	[[nodiscard]] net::StreamEncoder &encoder() { return *_encoder; }

	net::StreamSettings settings;
	double tick = 1.0; // end of the last window
	uint32_t next_id = 0;

private:
	static cga::Pose<double> pose(uint32_t body, double along) { return { { double(body), 0.05 * along, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 }; }
	double noise() {
		_random = _random * 6364136223846793005u + 1442695040888963407u;
		return double(_random >> 40) / double(1 << 22);
	}

	size_t _packet_size;
	std::unique_ptr<net::StreamEncoder> _encoder;
	uint32_t _count = 0;
	decltype(net::ChunkItem::number) _next_chunk = 0;
	uint8_t _snapshot_number = 0;
	uint64_t _random = 1;
};

} // namespace net_test
