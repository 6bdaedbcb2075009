#pragma once

#include "net/delivery/chunk_ring.hpp"
#include "net/delivery/congestion_control.hpp"
#include "net/delivery/fragment_buffer.hpp"
#include "net/delivery/loss_meter.hpp"
#include "net/stream/stream_settings.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace net {

/// Reliable delivery of a stream to one receiver: tracks what has arrived and decides what to send and retransmit, and how much at a
/// time. Times in seconds.
class Delivery {
public:
	/// Creates a delivery at `time`. The silence timer starts there.
	explicit Delivery(double time) :
			_heard(time) {}

	[[nodiscard]] bool needs_snapshot() const { return _needs_snapshot; }
	/// True if the receiver has acknowledged everything up to the ring's last chunk.
	[[nodiscard]] bool is_complete(const ChunkRing &ring) const { return !_needs_snapshot && _snapshot == nullptr && _first_missing == ring.next(); }
	/// Marks a snapshot as needed, unless the last request is too recent or a snapshot is arriving.
	void request_snapshot(double time);
	void start_snapshot(std::shared_ptr<const Snapshot> snapshot);
	/// Discards everything in flight. Nothing more is sent before start_snapshot().
	void restart();
	/// The same for a new stream to the receiver at `time`: the silence timer starts again.
	void restart(double time) {
		restart();
		_heard = time;
	}
	/// The estimated size of a snapshot, in bytes. A receiver that is late gets one instead of what it lacks only if that is larger.
	void set_snapshot_size(size_t bytes) { _snapshot_size = bytes; }

	/// Appends all packets that are due, of at most `max_size` bytes, to `bytes` and calls packet_done(begin, size) for each. If
	/// something in flight is too large to be sent again, a snapshot is needed.
	template <class PacketDone>
	void send(const ChunkRing &ring, double time, size_t max_size, std::vector<uint8_t> &bytes, PacketDone &&packet_done);
	/// Processes the acknowledgements and the snapshot request in a packet from the receiver.
	void accept(const PacketContent &acks, const ChunkRing &ring, double time);

	/// Loss assumed before any chunk has been acknowledged.
	static constexpr double INITIAL_PRIOR_LOSS = 0.015;
	/// After this many seconds without a packet from the receiver, the sender only probes it, at PROBE_INTERVAL. (A receiver
	/// that has not received any packet does not request a snapshot.)
	static constexpr double SILENCE = 3.0;
	static constexpr double PROBE_INTERVAL = 1.0;
	[[nodiscard]] bool is_silent(double time) const { return time - _heard > SILENCE; }
	/// Bytes that `send` may send at once above the mean of the stream: packets that arrive in bursts overflow the queues of lines.
	static constexpr double MAX_BURST = 3600.0;
	/// How long after its first transmission a chunk may arrive without stalling playback.
	void set_max_wait(double seconds) { _max_wait = seconds; }
	/// Retransmission timeout.
	[[nodiscard]] double rto() const;
	[[nodiscard]] double round_trip() const { return _round_trip; }
	[[nodiscard]] double round_trip_deviation() const { return _deviation; }
	/// Recent fraction of packets lost.
	[[nodiscard]] double loss() const { return _meter.loss() > (_is_urgent ? LOW_LOSS : HIGH_LOSS) ? std::max(_loss, _meter.loss()) : _loss; }
	/// loss() plus the prior, which decays as chunks arrive.
	[[nodiscard]] double expected_loss() const { return loss() + _prior_loss; }
	/// Number of retransmissions of chunks and fragments.
	[[nodiscard]] uint64_t retransmissions() const { return _retransmissions; }

	[[nodiscard]] const CongestionControl &congestion() const { return _congestion; }
	/// True if a large part of the snapshot in flight had to be sent again.
	[[nodiscard]] bool is_losing_snapshot() const;
	/// Bytes of the stream that have not been sent to the receiver yet.
	[[nodiscard]] size_t backlog(const ChunkRing &ring) const { return _needs_snapshot ? 0 : ring.bytes_from(_unsent); }
	/// The first chunk that has not been sent to it.
	[[nodiscard]] uint32_t unsent() const { return _unsent; }
	/// The first chunk that the receiver may still need.
	[[nodiscard]] uint32_t first_missing() const { return _first_missing; }

private:
	/// Above this loss, chunks are sent several times before a timeout.
	static constexpr double HIGH_LOSS = 0.1;
	/// The same if a timeout would stall playback.
	static constexpr double LOW_LOSS = 0.015;

	struct Sent {
		double first = 0.0; // time of the first transmission
		double second = 0.0;
		double time = 0.0; // of the last
		double round = 0.0; // of the last that was due after a timeout
		uint32_t in_flight = 0; // bytes
		uint8_t times = 0;
		uint8_t rounds = 0; // transmissions that were due after a timeout, and the first
		bool is_paired = false; // sent again since the last timeout
		bool arrived = false;
		bool lost = false; // counted as lost
	};

	void collect_due(const ChunkRing &ring, double time, size_t max_size);
	void collect_fragments(double time, size_t &budget);
	void collect_chunks(const ChunkRing &ring, double time, size_t max_size, size_t budget);
	/// Grows the table of chunks in flight to cover all up to `end`.
	void make_room(uint32_t end);
	[[nodiscard]] Sent &sent(uint32_t number) { return _sent[number & (_sent.size() - 1)]; }
	[[nodiscard]] size_t max_burst(const ChunkRing &ring, double time);
	/// True if it is to be sent for the first time or after a timeout.
	[[nodiscard]] bool is_due(const Sent &sent, double time) const;
	void note_timeout(Sent &sent, double time);
	/// Time between copies of a chunk before a timeout; infinite if it can wait for the timeout.
	[[nodiscard]] double copy_interval() const;
	/// True if a retransmission is to be sent again.
	[[nodiscard]] static bool is_pair_due(const Sent &sent, double time);
	void mark_due(Sent &sent, size_t size, double time);
	void mark_sent(Sent &sent, size_t size, double time);
	void request_if_late(const ChunkRing &ring, double time);
	void take_ack(const AckItem &ack, const ChunkRing &ring, double time);
	void take_snapshot_ack(const SnapshotAckItem &ack, double time);
	/// At first transmission, the receiver's first missing chunk is between ours and this chunk, so 4 bits identify the number.
	[[nodiscard]] bool can_be_short(uint32_t number) { return _snapshot == nullptr && sent(number).times == 1 && number - _first_missing < ChunkItem::SHORT_REACH; }
	/// The same for 8 bits, as long as few chunks are in flight.
	[[nodiscard]] bool can_be_narrow(const ChunkRing &ring) const { return _snapshot == nullptr && ring.next() - _first_missing < ChunkItem::NARROW_REACH; }
	void finish_snapshot();
	/// `is_newest`: of all that a packet acknowledges.
	void arrived(Sent &sent, double time, bool is_newest);
	void measure(double round_trip);

	double _heard;
	bool _needs_snapshot = true;
	double _snapshot_time = -1e9; // time of the last request
	double _fragment_time = -1e9; // when a fragment was last acknowledged, or the snapshot started
	size_t _snapshot_size = 0;
	std::shared_ptr<const Snapshot> _snapshot; // the snapshot in flight; null once it is acknowledged
	std::vector<Sent> _fragments;
	uint32_t _first_missing = 0;
	uint32_t _unsent = 0; // chunks from here on have not been sent
	std::vector<Sent> _sent = std::vector<Sent>(16); // by chunk number, modulo their count, which is a power of two
	std::vector<uint16_t> _due_fragments;
	std::vector<uint32_t> _due_chunks;
	CongestionControl _congestion;
	size_t _acknowledged = 0; // bytes in flight that the last packet has acknowledged
	double _sample = 0.0; // its round-trip sample; 0: it has none
	double _sent_at = -1e9; // time of the last call of `send`
	double _round_trip = 0.0;
	double _deviation = 0.0;
	int _samples = 0; // of the round trip, up to FIRST_SAMPLES
	double _round_trip_sent = -1e9; // time of the last round-trip item
	double _probed = -1e9; // time of the last probe
	double _loss = 0.0; // recent fraction of chunks that had not arrived after a timeout
	LossMeter _meter;
	double _lost = -1e9; // when a chunk was last counted as lost
	double _max_wait = 1e9;
	bool _is_urgent = false; // chunks get lost, and a timeout would stall playback
	double _prior_loss = INITIAL_PRIOR_LOSS;
	int _ambiguous = 0; // ambiguous acknowledgements since the last round-trip sample
	uint64_t _retransmissions = 0;
};

template <class PacketDone>
void Delivery::send(const ChunkRing &ring, double time, size_t max_size, std::vector<uint8_t> &bytes, PacketDone &&packet_done) {
	if (is_silent(time)) {
		if (time - _probed >= PROBE_INTERVAL) {
			_probed = time;
			const size_t begin = bytes.size();
			put_round_trip(bytes, _round_trip);
			_meter.sent(time);
			packet_done(begin, bytes.size() - begin);
		}
		return;
	}
	collect_due(ring, time, max_size);
	size_t begin = bytes.size();
	const auto finish_packet = [&] {
		_meter.sent(time);
		packet_done(begin, bytes.size() - begin);
		begin = bytes.size();
	};
	const auto make_room = [&](size_t item) {
		if (bytes.size() > begin && bytes.size() - begin + item > max_size) {
			finish_packet();
		}
	};
	for (const uint16_t index : _due_fragments) {
		const size_t offset = index * _snapshot->fragment_size;
		const FragmentItem fragment{ _snapshot->number, uint16_t(_snapshot->next_chunk), index, uint16_t(_snapshot->fragment_count()), _snapshot->bytes.data() + offset, _snapshot->size_of(index) };
		make_room(fragment.size + FRAGMENT_HEADER);
		put_fragment(bytes, fragment);
	}
	constexpr double ROUND_TRIP_INTERVAL = 5.0;
	if (!_due_chunks.empty() && _round_trip > 0.0 && time - _round_trip_sent > ROUND_TRIP_INTERVAL) {
		make_room(ROUND_TRIP_BYTES);
		put_round_trip(bytes, _round_trip);
		_round_trip_sent = time;
	}
	const bool is_wide = !can_be_narrow(ring);
	for (size_t i = 0; i < _due_chunks.size(); ++i) {
		const ChunkRing::Chunk &chunk = ring.chunk(_due_chunks[i]);
		const bool is_short = chunk.first && chunk.last && can_be_short(_due_chunks[i]);
		const ChunkItem item{ uint16_t(_due_chunks[i]), chunk.first, chunk.last, chunk.check, chunk.bytes.data(), chunk.bytes.size(), is_short, is_wide };
		make_room(item.size + CHUNK_HEADER);
		// A packet's last item needs no length. This is the last one if the next does not fit.
		const bool is_last = i + 1 == _due_chunks.size() || bytes.size() - begin + item.size + 2 * CHUNK_HEADER + ring.chunk(_due_chunks[i + 1]).bytes.size() > max_size;
		put_chunk(bytes, item, is_last);
		if (is_last) {
			finish_packet();
		}
	}
	if (bytes.size() > begin) {
		finish_packet();
	}
}

} // namespace net
