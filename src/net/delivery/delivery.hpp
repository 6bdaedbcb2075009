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
			heard_(time) {}

	[[nodiscard]] bool needs_state() const { return needs_state_; }
	/// Asks for a whole state. Not more often than it makes sense.
	void want_state(double time);
	void start_state(std::shared_ptr<const StateSnapshot> state);

	/// Appends packets with everything that is due; `packet_done` is called with the end of each in `bytes`.
	template <class PacketDone>
	void send(const ChunkRing &ring, double time, std::vector<std::uint8_t> &bytes, PacketDone &&packet_done);
	/// Takes an answer.
	void accept(const PacketContent &answer, const ChunkRing &ring, double time);

	/// Loss that is expected of a line of which nothing is known.
	static constexpr double FIRST_CAUTION = 0.015;
	/// A receiver that has not been heard for so long gets nothing more until it is, but for a few bytes now and then:
	/// one that knows nothing yet does not know whom to ask.
	static constexpr double SILENCE = 3.0;
	static constexpr double PROBE_PAUSE = 1.0;
	[[nodiscard]] bool is_silent(double time) const { return time - heard_ > SILENCE; }
	/// After this a chunk counts as lost.
	[[nodiscard]] double patience() const;
	[[nodiscard]] double round_trip() const { return round_trip_; }
	[[nodiscard]] double round_trip_deviation() const { return deviation_; }
	[[nodiscard]] double loss() const { return loss_; }
	/// Loss with the caution that a new receiver's line deserves.
	[[nodiscard]] double expected_loss() const { return loss_ + caution_; }
	[[nodiscard]] std::uint64_t repeated() const { return repeated_; }

private:
	struct Sent {
		double first = 0.0; // time of the first try
		double time = 0.0; // of the last
		std::uint8_t times = 0;
		bool arrived = false;
		bool missed = false; // counted as lost
	};

	void collect_due(const ChunkRing &ring, double time);
	void take_ack(const AckItem &ack, const ChunkRing &ring, double time);
	void take_state_ack(const StateAckItem &ack);
	[[nodiscard]] bool can_be_short(std::uint32_t number) const;
	void chunk_arrived(std::uint32_t number, double time, bool is_newest);
	void measure(double round_trip);

	double heard_;
	bool needs_state_ = true;
	double state_made_ = -1e9;
	std::shared_ptr<const StateSnapshot> state_; // until all of it has arrived
	std::vector<Sent> parts_;
	std::uint32_t first_missing_ = 0;
	std::array<Sent, ChunkRing::RING> sent_;
	std::uint32_t sent_until_ = 0; // chunks from here on were never sent
	std::vector<std::uint16_t> due_parts_;
	std::vector<std::uint32_t> due_chunks_;
	double round_trip_ = 0.0;
	double deviation_ = 0.0;
	double told_round_trip_ = -1e9; // when
	double probed_ = -1e9; // when
	double loss_ = 0.0;
	double caution_ = FIRST_CAUTION; // fades as chunks arrive
	int uncertain_ = 0; // answers since the last round trip was measured
	std::uint64_t repeated_ = 0;
};

template <class PacketDone>
void Delivery::send(const ChunkRing &ring, double time, std::vector<std::uint8_t> &bytes, PacketDone &&packet_done) {
	if (is_silent(time)) {
		if (time - probed_ >= PROBE_PAUSE) {
			probed_ = time;
			const std::size_t begin = bytes.size();
			put_round_trip(bytes, round_trip_);
			packet_done(begin, bytes.size() - begin);
		}
		return;
	}
	collect_due(ring, time);
	std::size_t begin = bytes.size();
	const auto make_room = [&](std::size_t item) {
		if (bytes.size() > begin && bytes.size() - begin + item > std::size_t(MOST_PACKET_BYTES)) {
			packet_done(begin, bytes.size() - begin);
			begin = bytes.size();
		}
	};
	for (const std::uint16_t index : due_parts_) {
		StatePartItem part;
		part.state = state_->number;
		part.next_chunk = std::uint8_t(state_->next_chunk);
		part.part = index;
		part.parts = std::uint16_t(state_->parts());
		part.bytes = state_->bytes.data() + index * StateSnapshot::PART_BYTES;
		part.size = std::min(StateSnapshot::PART_BYTES, state_->bytes.size() - index * StateSnapshot::PART_BYTES);
		make_room(part.size + STATE_PART_HEADER);
		put_state_part(bytes, part);
	}
	constexpr double TELL_EVERY = 5.0;
	if (!due_chunks_.empty() && round_trip_ > 0.0 && time - told_round_trip_ > TELL_EVERY) {
		make_room(ROUND_TRIP_BYTES);
		put_round_trip(bytes, round_trip_);
		told_round_trip_ = time;
	}
	for (std::size_t i = 0; i < due_chunks_.size(); ++i) {
		const ChunkRing::Chunk &chunk = ring.chunk(due_chunks_[i]);
		ChunkItem item;
		item.number = std::uint8_t(due_chunks_[i]);
		item.first = chunk.first;
		item.last = chunk.last;
		item.check = chunk.check;
		item.bytes = chunk.bytes.data();
		item.size = chunk.size;
		item.is_short = chunk.first && chunk.last && can_be_short(due_chunks_[i]);
		make_room(item.size + CHUNK_HEADER);
		// The last item of a packet needs no length: so is this one, if the next does not fit.
		const bool is_last = i + 1 == due_chunks_.size() || bytes.size() - begin + item.size + 2 * CHUNK_HEADER + ring.chunk(due_chunks_[i + 1]).size > std::size_t(MOST_PACKET_BYTES);
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
