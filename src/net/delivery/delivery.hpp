#pragma once

#include "net/delivery/chunk_ring.hpp"
#include "net/delivery/state_parts.hpp"
#include "net/stream_settings.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace net {

/// What one receiver has of a stream, and when to send it what it lacks. Times in seconds.
class Delivery {
public:
	/// `time` counts as the last time that the receiver was heard.
	explicit Delivery(double time) :
			_heard(time) {}

	[[nodiscard]] bool needs_state() const { return _needs_state; }
	/// Asks for a whole state. Not more often than it makes sense.
	void want_state(double time);
	void start_state(std::shared_ptr<const StateSnapshot> state);

	/// Appends packets with everything that is due; `packet_done` is called with the end of each in `bytes`.
	template <class PacketDone>
	void send(const ChunkRing &ring, double time, std::vector<uint8_t> &bytes, PacketDone &&packet_done);
	/// Takes an answer.
	void accept(const PacketContent &answer, const ChunkRing &ring, double time);

	/// Loss that is expected of a line of which nothing is known.
	static constexpr double FIRST_CAUTION = 0.015;
	/// A receiver that has not been heard for so long gets nothing more until it is, but for a few bytes now and then:
	/// one that knows nothing yet does not know whom to ask.
	static constexpr double SILENCE = 3.0;
	static constexpr double PROBE_PAUSE = 1.0;
	[[nodiscard]] bool is_silent(double time) const { return time - _heard > SILENCE; }
	/// After this a chunk counts as lost.
	[[nodiscard]] double patience() const;
	[[nodiscard]] double round_trip() const { return _round_trip; }
	[[nodiscard]] double round_trip_deviation() const { return _deviation; }
	[[nodiscard]] double loss() const { return _loss; }
	/// Loss with the caution that a new receiver's line deserves.
	[[nodiscard]] double expected_loss() const { return _loss + _caution; }
	[[nodiscard]] uint64_t repeated() const { return _repeated; }

private:
	struct Sent {
		double first = 0.0; // time of the first try
		double time = 0.0; // of the last
		uint8_t times = 0;
		bool arrived = false;
		bool missed = false; // counted as lost
	};

	void collect_due(const ChunkRing &ring, double time);
	void take_ack(const AckItem &ack, const ChunkRing &ring, double time);
	void take_state_ack(const StateAckItem &ack);
	[[nodiscard]] bool can_be_short(uint32_t number) const;
	void chunk_arrived(uint32_t number, double time, bool is_newest);
	void measure(double round_trip);

	double _heard;
	bool _needs_state = true;
	double _state_made = -1e9;
	std::shared_ptr<const StateSnapshot> _state; // until all of it has arrived
	std::vector<Sent> _parts;
	uint32_t _first_missing = 0;
	std::array<Sent, ChunkRing::RING> _sent;
	uint32_t _sent_until = 0; // chunks from here on were never sent
	std::vector<uint16_t> _due_parts;
	std::vector<uint32_t> _due_chunks;
	double _round_trip = 0.0;
	double _deviation = 0.0;
	double _told_round_trip = -1e9; // when
	double _probed = -1e9; // when
	double _loss = 0.0;
	double _caution = FIRST_CAUTION; // fades as chunks arrive
	int _uncertain = 0; // answers since the last round trip was measured
	uint64_t _repeated = 0;
};

template <class PacketDone>
void Delivery::send(const ChunkRing &ring, double time, std::vector<uint8_t> &bytes, PacketDone &&packet_done) {
	if (is_silent(time)) {
		if (time - _probed >= PROBE_PAUSE) {
			_probed = time;
			const size_t begin = bytes.size();
			put_round_trip(bytes, _round_trip);
			packet_done(begin, bytes.size() - begin);
		}
		return;
	}
	collect_due(ring, time);
	size_t begin = bytes.size();
	const auto make_room = [&](size_t item) {
		if (bytes.size() > begin && bytes.size() - begin + item > size_t(MAX_PACKET_BYTES)) {
			packet_done(begin, bytes.size() - begin);
			begin = bytes.size();
		}
	};
	for (const uint16_t index : _due_parts) {
		StatePartItem part;
		part.state = _state->number;
		part.next_chunk = uint8_t(_state->next_chunk);
		part.part = index;
		part.parts = uint16_t(_state->parts());
		part.bytes = _state->bytes.data() + index * StateSnapshot::PART_BYTES;
		part.size = std::min(StateSnapshot::PART_BYTES, _state->bytes.size() - index * StateSnapshot::PART_BYTES);
		make_room(part.size + STATE_PART_HEADER);
		put_state_part(bytes, part);
	}
	constexpr double TELL_EVERY = 5.0;
	if (!_due_chunks.empty() && _round_trip > 0.0 && time - _told_round_trip > TELL_EVERY) {
		make_room(ROUND_TRIP_BYTES);
		put_round_trip(bytes, _round_trip);
		_told_round_trip = time;
	}
	for (size_t i = 0; i < _due_chunks.size(); ++i) {
		const ChunkRing::Chunk &chunk = ring.chunk(_due_chunks[i]);
		ChunkItem item;
		item.number = uint8_t(_due_chunks[i]);
		item.first = chunk.first;
		item.last = chunk.last;
		item.check = chunk.check;
		item.bytes = chunk.bytes.data();
		item.size = chunk.size;
		item.is_short = chunk.first && chunk.last && can_be_short(_due_chunks[i]);
		make_room(item.size + CHUNK_HEADER);
		// The last item of a packet needs no length: so is this one, if the next does not fit.
		const bool is_last = i + 1 == _due_chunks.size() || bytes.size() - begin + item.size + 2 * CHUNK_HEADER + ring.chunk(_due_chunks[i + 1]).size > size_t(MAX_PACKET_BYTES);
		put_chunk(bytes, item, is_last);
		if (is_last) {
			packet_done(begin, bytes.size() - begin);
			begin = bytes.size();
		}
	}
	if (bytes.size() > begin) {
		packet_done(begin, bytes.size() - begin);
	}
}

} // namespace net
