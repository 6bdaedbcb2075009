#include "net/delivery/delivery.hpp"

#include "net/coding/portable_math.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace net {

namespace {

// Retransmission timeout, in seconds.
constexpr double INITIAL_RTO = 0.2; // before the first round-trip sample
constexpr double MIN_RTO = 0.03;
constexpr double MAX_RTO = 0.5; // raised to 1.25 round trips on slow connections
constexpr double MIN_DEVIATION = 0.005; // covers the frame and tick intervals at both ends
/// A receiver gets a new snapshot after this many retransmissions of one chunk, or if it is this many chunks behind.
constexpr int MAX_RETRANSMISSIONS = 8;
constexpr double STUCK_TIME = 1.5; // seconds; below this, the round trip may merely be longer than estimated
constexpr uint32_t MAX_CHUNKS_BEHIND = 100;
/// Absolute limit, also while a snapshot is in flight: beyond it, unacknowledged chunks would soon leave the ring.
constexpr uint32_t MAX_CHUNKS_KEPT = 200;
constexpr double SNAPSHOT_INTERVAL = 0.5; // seconds
/// Number of retransmissions before back-off starts.
constexpr int PROMPT_RETRANSMISSIONS = 3;
/// A retransmission is sent again after this time, as a second loss would be noticed too late.
constexpr double PAIR_INTERVAL = 0.01;
/// At a loss p, copies are COPY_INTERVAL * -ln p apart, so that all copies of some time are lost with the same probability
/// at any p. Just above the loss at which copies begin, they are farther apart.
constexpr double COPY_INTERVAL = 0.05;
constexpr double LN_2 = 0.69314718055994530942;
/// For this many seconds after a loss, others are expected.
constexpr double LOSS_MEMORY = 30.0;
/// A packet that is sent anyway takes copies that are due after this fraction of their interval.
constexpr double EARLY_COPY = 0.5;
/// After this many consecutive ambiguous acknowledgements, an ambiguous one is used as a round-trip sample.
constexpr int MAX_AMBIGUOUS = 8;
/// Weight of one chunk in the moving average of the loss.
constexpr double LOSS_WEIGHT = 1.0 / 32.0;

} // namespace

void Delivery::request_snapshot(double time) {
	if (time - _snapshot_time >= SNAPSHOT_INTERVAL) {
		_needs_snapshot = true;
		_snapshot_time = time;
	}
}

void Delivery::start_snapshot(std::shared_ptr<const Snapshot> snapshot) {
	_needs_snapshot = false;
	_snapshot = std::move(snapshot);
	_fragments.assign(_snapshot->fragment_count(), Sent());
	_first_missing = _snapshot->next_chunk;
	_sent_until = _snapshot->next_chunk;
}

double Delivery::rto() const {
	const double longest = std::max(MAX_RTO, 1.25 * _round_trip);
	return _round_trip > 0.0 ? std::clamp(_round_trip + 4.0 * std::max(_deviation, MIN_DEVIATION), MIN_RTO, longest) : INITIAL_RTO;
}

void Delivery::mark_sent(Sent &sent, double time) {
	_retransmissions += sent.times > 0 ? 1 : 0;
	sent.second = sent.times == 1 ? time : sent.second;
	sent.times = uint8_t(std::min<int>(sent.times + 1, 255));
	sent.time = time;
}

bool Delivery::is_due(Sent &sent, double time) {
	if (sent.arrived) {
		return false;
	}
	const double timeout = rto();
	if (sent.times == 0) {
		sent.first = time;
	} else if (!sent.lost && time - sent.first >= timeout) {
		sent.lost = true;
		_lost = time;
		_loss += (1.0 - _loss) * LOSS_WEIGHT;
	}
	// The interval backs off linearly, up to 4 timeouts.
	if (sent.times > 0 && time - sent.round < timeout * std::clamp(sent.rounds - PROMPT_RETRANSMISSIONS, 1, 4)) {
		return false;
	}
	sent.round = time;
	sent.rounds = uint8_t(std::min<int>(sent.rounds + 1, 255));
	sent.is_paired = false;
	mark_sent(sent, time);
	return true;
}

double Delivery::copy_interval() const {
	const double bound = _is_urgent ? LOW_LOSS : HIGH_LOSS;
	const double p = _is_urgent ? _meter.loss() : loss();
	return p > bound ? COPY_INTERVAL * -LN_2 * portable_log2(std::min(p, 0.9)) / std::min(p / bound - 1.0, 1.0) : std::numeric_limits<double>::infinity();
}

bool Delivery::is_copy_due(const Sent &sent, double time, double interval) {
	if (sent.arrived || sent.times == 0) {
		return false;
	}
	const bool is_pair_due = sent.rounds > 1 && !sent.is_paired && time - sent.time >= PAIR_INTERVAL;
	return is_pair_due || time - sent.time >= interval;
}

void Delivery::collect_due(const ChunkRing &ring, double time, size_t max_size) {
	_due_fragments.clear();
	_due_chunks.clear();
	if (_snapshot != nullptr && _snapshot->fragment_size + FRAGMENT_HEADER > max_size) {
		restart();
	}
	if (_needs_snapshot) {
		return;
	}
	for (size_t i = 0; i < _fragments.size(); ++i) {
		if (is_due(_fragments[i], time)) {
			_due_fragments.push_back(uint16_t(i));
		}
	}
	_sent_until = std::max(_sent_until, ring.next() > ChunkRing::RING ? ring.next() - ChunkRing::RING : 0);
	// Copies must not multiply the bytes of a large stream: they only fill one packet.
	size_t new_bytes = 0;
	for (; _sent_until < ring.next(); ++_sent_until) {
		_sent[_sent_until % ChunkRing::RING] = Sent();
		new_bytes += CHUNK_HEADER + ring.chunk(_sent_until).bytes.size();
	}
	const uint32_t behind = ring.next() - _first_missing;
	if (behind > MAX_CHUNKS_KEPT) {
		request_snapshot(time);
		return;
	}
	_is_urgent = rto() + 3.0 * _deviation > _max_wait && time - _lost < LOSS_MEMORY;
	const double interval = copy_interval() * (new_bytes > 0 ? EARLY_COPY : 1.0);
	const bool is_far_behind = _fragments.empty() && behind > MAX_CHUNKS_BEHIND;
	size_t packet = new_bytes;
	for (uint32_t number = _first_missing; number < ring.next(); ++number) {
		Sent &sent = _sent[number % ChunkRing::RING];
		const size_t size = CHUNK_HEADER + ring.chunk(number).bytes.size();
		if (is_due(sent, time)) {
			_due_chunks.push_back(number);
			if (size > max_size) {
				restart();
				_due_fragments.clear();
				_due_chunks.clear();
				return;
			}
		} else if (packet + size <= max_size && is_copy_due(sent, time, interval)) {
			packet += size;
			sent.is_paired = true;
			mark_sent(sent, time);
			_due_chunks.push_back(number);
		}
	}
	const Sent &oldest = _sent[_first_missing % ChunkRing::RING];
	const bool is_stuck = _fragments.empty() && _first_missing < ring.next() && oldest.rounds > MAX_RETRANSMISSIONS && time - oldest.first > STUCK_TIME;
	if (is_far_behind || is_stuck) {
		request_snapshot(time);
	}
}

void Delivery::accept(const PacketContent &acks, const ChunkRing &ring, double time) {
	_heard = time;
	for (const AckItem &ack : acks.acks) {
		take_ack(ack, ring, time);
	}
	for (const SnapshotAckItem &ack : acks.snapshot_acks) {
		take_snapshot_ack(ack);
	}
	if (acks.requests_snapshot) {
		request_snapshot(time);
	}
}

void Delivery::take_ack(const AckItem &ack, const ChunkRing &ring, double time) {
	_meter.reported(ack.packets, time - _round_trip);
	const uint8_t ahead = uint8_t(ack.next - uint8_t(_first_missing));
	if (_needs_snapshot || ring.next() - _first_missing > MAX_CHUNKS_KEPT || ahead > ring.next() - _first_missing) {
		return; // stale, or from another stream
	}
	if (_snapshot != nullptr && ack.next == uint8_t(_first_missing) && ack.later == 0 && !_fragments.empty()) {
		return; // snapshot fragments are acknowledged separately
	}
	const uint32_t next = _first_missing + ahead;
	// The newest chunk caused this acknowledgement. Others may have arrived earlier, if an acknowledgement was lost.
	bool is_newest = true;
	for (int bit = 63; bit >= 0; --bit) {
		const uint32_t number = next + 1 + uint32_t(bit);
		if (((ack.later >> bit) & 1) != 0 && number < ring.next()) {
			chunk_arrived(number, time, is_newest);
			is_newest = false;
		}
	}
	for (uint32_t number = next; number-- > _first_missing;) {
		chunk_arrived(number, time, is_newest);
		is_newest = false;
	}
	_first_missing = next;
	while (_first_missing < ring.next() && _first_missing < _sent_until && _sent[_first_missing % ChunkRing::RING].arrived) {
		++_first_missing;
	}
	if (ahead > 0) {
		// A receiver acknowledges chunks in order only once it has the snapshot.
		_snapshot.reset();
		_fragments.clear();
	}
}

void Delivery::take_snapshot_ack(const SnapshotAckItem &ack) {
	if (_snapshot == nullptr || ack.snapshot != _snapshot->number) {
		return;
	}
	bool complete = true;
	for (size_t i = 0; i < _fragments.size(); ++i) {
		const size_t after = i - ack.next - 1;
		_fragments[i].arrived = _fragments[i].arrived || i < ack.next || (i > ack.next && after < 32 && ((ack.later >> after) & 1) != 0);
		complete = complete && _fragments[i].arrived;
	}
	if (complete) {
		_snapshot.reset();
		_fragments.clear();
	}
}

void Delivery::chunk_arrived(uint32_t number, double time, bool is_newest) {
	Sent &sent = _sent[number % ChunkRing::RING];
	if (sent.arrived || sent.times == 0) {
		return;
	}
	sent.arrived = true;
	// Karn's algorithm: a retransmitted chunk gives no round-trip sample, unless its acknowledgement comes too soon to belong to
	// the retransmission. A long run of ambiguous ones means that the RTO is too short: most belong to the first transmission.
	if (is_newest) {
		const bool is_unambiguous = sent.times == 1 || time - sent.second < (sent.rounds == 1 ? 0.8 : 0.5) * _round_trip;
		_ambiguous = is_unambiguous ? 0 : _ambiguous + 1;
		if (_ambiguous == MAX_AMBIGUOUS) {
			_ambiguous = 0;
			_round_trip = 0.0;
		}
		if (is_unambiguous || _round_trip == 0.0) {
			measure(std::max(time - sent.first, 1e-4));
		}
	}
	_prior_loss -= _prior_loss * LOSS_WEIGHT;
	if (!sent.lost) {
		_loss -= _loss * LOSS_WEIGHT;
	}
}

void Delivery::measure(double round_trip) {
	// Jacobson, "Congestion Avoidance and Control", 1988.
	if (_round_trip == 0.0) {
		_round_trip = round_trip;
		_deviation = 0.5 * round_trip;
		return;
	}
	_deviation += (std::fabs(round_trip - _round_trip) - _deviation) / 4.0;
	_round_trip += (round_trip - _round_trip) / 8.0;
}

} // namespace net
