#include "net/delivery/delivery.hpp"

#include "net/coding/portable_math.hpp"
#include "net/delivery/chunk_buffer.hpp"

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
constexpr double FIRST_DEVIATION = 0.02; // the same for the first round-trip samples
constexpr int FIRST_SAMPLES = 8;
/// A chunk that has not arrived after this many retransmissions, or its first one this many seconds ago, is late.
constexpr int MAX_RETRANSMISSIONS = 8;
constexpr double STUCK_TIME = 1.5; // below this, the round trip may merely be longer than estimated
constexpr double SNAPSHOT_INTERVAL = 0.5; // seconds
/// A snapshot of which nothing has been acknowledged for this many seconds may be replaced.
constexpr double SNAPSHOT_TIMEOUT = 2.0;
/// A snapshot that is at least this many times smaller than what the receiver lacks replaces it.
constexpr size_t WORTHWHILE = 2;
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
/// If a chunk was sent several times, an acknowledgement more than this many seconds after the first transmission is not for that one.
constexpr double MAX_AMBIGUOUS_SAMPLE = 2.0;
/// Weight of one chunk in the moving average of the loss.
constexpr double LOSS_WEIGHT = 1.0 / 32.0;

} // namespace

void Delivery::request_snapshot(double time) {
	const bool is_arriving = _snapshot != nullptr && time - _fragment_time < SNAPSHOT_TIMEOUT;
	if (time - _snapshot_time >= SNAPSHOT_INTERVAL && !is_arriving) {
		_needs_snapshot = true;
		_snapshot_time = time;
	}
}

void Delivery::start_snapshot(std::shared_ptr<const Snapshot> snapshot) {
	restart();
	_needs_snapshot = false;
	_snapshot = std::move(snapshot);
	_fragments.assign(_snapshot->fragment_count(), Sent());
	_fragment_time = std::max(_sent_at, _heard);
	_first_missing = _unsent = _snapshot->next_chunk;
}

void Delivery::restart() {
	for (uint32_t number = _first_missing; number < _unsent; ++number) {
		_congestion.left(sent(number).in_flight);
		sent(number) = Sent();
	}
	_unsent = _first_missing;
	finish_snapshot();
	_needs_snapshot = true;
}

void Delivery::finish_snapshot() {
	if (_snapshot == nullptr) {
		return;
	}
	for (const Sent &fragment : _fragments) {
		_congestion.left(fragment.in_flight);
	}
	_fragments.clear();
	_snapshot.reset();
	for (uint32_t number = _first_missing; number < _unsent; ++number) {
		sent(number).round = std::max(sent(number).round, _heard); // it could not be acknowledged before
	}
}

double Delivery::rto() const {
	const double longest = std::max(MAX_RTO, 1.25 * _round_trip);
	// At first, little is known of the deviation.
	const double deviation = std::max(_deviation, _samples < FIRST_SAMPLES ? FIRST_DEVIATION : MIN_DEVIATION);
	return _round_trip > 0.0 ? std::clamp(_round_trip + 4.0 * deviation, MIN_RTO, longest) : INITIAL_RTO;
}

void Delivery::mark_sent(Sent &sent, size_t size, double time) {
	_retransmissions += sent.times > 0 ? 1 : 0;
	sent.second = sent.times == 1 ? time : sent.second;
	sent.first = sent.times == 0 ? time : sent.first;
	sent.times = uint8_t(std::min<int>(sent.times + 1, 255));
	sent.time = time;
	sent.in_flight += uint32_t(size);
	_congestion.sent(size);
}

void Delivery::mark_due(Sent &sent, size_t size, double time) {
	sent.round = time;
	sent.rounds = uint8_t(std::min<int>(sent.rounds + 1, 255));
	sent.is_paired = false;
	mark_sent(sent, size, time);
}

bool Delivery::is_due(const Sent &sent, double time) const {
	if (sent.arrived || sent.times == 0) {
		return !sent.arrived;
	}
	// The interval backs off linearly, up to 4 timeouts.
	return time - sent.round >= rto() * std::clamp(sent.rounds - PROMPT_RETRANSMISSIONS, 1, 4);
}

void Delivery::note_timeout(Sent &sent, double time) {
	if (sent.arrived || sent.times == 0 || time - sent.round < rto()) {
		return;
	}
	_congestion.lost(sent.in_flight, sent.time);
	sent.in_flight = 0;
	if (!sent.lost) {
		sent.lost = true;
		_lost = _congestion.has_queue() ? _lost : time; // more copies would not help
		_loss += (1.0 - _loss) * LOSS_WEIGHT;
	}
}

double Delivery::copy_interval() const {
	const double bound = _is_urgent ? LOW_LOSS : HIGH_LOSS;
	const double p = _is_urgent ? _meter.loss() : loss();
	return p > bound ? COPY_INTERVAL * -LN_2 * portable_log2(std::min(p, 0.9)) / std::min(p / bound - 1.0, 1.0) : std::numeric_limits<double>::infinity();
}

bool Delivery::is_pair_due(const Sent &sent, double time) {
	return !sent.arrived && sent.rounds > 1 && !sent.is_paired && time - sent.time >= PAIR_INTERVAL;
}

size_t Delivery::max_burst(const ChunkRing &ring, double time) {
	constexpr double MAX_STEP = 0.1;
	const double step = std::clamp(time - _sent_at, 0.0, MAX_STEP);
	_sent_at = time;
	return size_t(MAX_BURST + ring.rate() * step);
}

void Delivery::collect_due(const ChunkRing &ring, double time, size_t max_size) {
	_due_fragments.clear();
	_due_chunks.clear();
	const size_t burst = max_burst(ring, time);
	if (_snapshot != nullptr && _snapshot->fragment_size + FRAGMENT_HEADER > max_size) {
		restart();
	}
	if (_needs_snapshot) {
		return;
	}
	for (Sent &fragment : _fragments) {
		note_timeout(fragment, time);
	}
	// Chunks are acknowledged only once the snapshot has arrived.
	for (uint32_t number = _first_missing; _fragments.empty() && number < _unsent; ++number) {
		note_timeout(sent(number), time);
	}
	request_if_late(ring, time);
	if (_needs_snapshot) {
		return;
	}
	const size_t allowance = _congestion.allowance(time);
	size_t budget = std::min(allowance, burst);
	collect_fragments(time, budget);
	collect_chunks(ring, time, max_size, budget);
	const bool is_rest = !_needs_snapshot && (ring.bytes_from(_unsent) > 0 || std::any_of(_fragments.begin(), _fragments.end(), [](const Sent &sent) { return sent.times == 0; }));
	if (is_rest && allowance < burst) {
		_congestion.set_limited();
	}
}

void Delivery::collect_fragments(double time, size_t &budget) {
	for (size_t i = 0; i < _fragments.size(); ++i) {
		const size_t size = FRAGMENT_HEADER + _snapshot->size_of(i);
		if (is_due(_fragments[i], time)) {
			if (size > budget) {
				budget = 0; // chunks wait, too
				return;
			}
			budget -= size;
			mark_due(_fragments[i], size, time);
			_due_fragments.push_back(uint16_t(i));
		}
	}
}

void Delivery::collect_chunks(const ChunkRing &ring, double time, size_t max_size, size_t budget) {
	const bool is_joining = !_fragments.empty();
	if (is_joining && (_congestion.is_half_full() || std::any_of(_fragments.begin(), _fragments.end(), [this](const Sent &sent) { return sent.times == 0 || (sent.times > 1 && _congestion.is_validated()); }))) {
		return; // fragments come first, and nothing else while the line loses them
	}
	// Copies before a timeout must not multiply the bytes of a large stream: they only fill one packet. Over a line that is full they would
	// cause what they are to prevent.
	const bool may_copy = !_congestion.is_limiting() && !_congestion.has_queue();
	const size_t new_bytes = ring.bytes_from(_unsent);
	_is_urgent = rto() + 3.0 * _deviation > _max_wait && time - _lost < LOSS_MEMORY;
	const double interval = copy_interval() * (new_bytes > 0 ? EARLY_COPY : 1.0);
	size_t packet = new_bytes;
	const uint32_t end = std::min(ring.next(), _first_missing + uint32_t(ChunkBuffer::MAX_AHEAD));
	make_room(end);
	for (uint32_t number = is_joining ? _unsent : _first_missing; number < end; ++number) {
		Sent &sent = this->sent(number);
		if (number == _unsent) {
			sent = Sent();
		}
		const size_t size = CHUNK_HEADER + ring.chunk(number).bytes.size();
		const bool is_copy = may_copy && !sent.arrived && sent.times > 0 && time - sent.time >= interval && packet + size <= max_size;
		if (!is_due(sent, time) && !is_pair_due(sent, time) && !is_copy) {
			continue;
		}
		if (size > max_size) {
			restart();
			_due_fragments.clear();
			_due_chunks.clear();
			return;
		}
		// The first packet may exceed the budget: it may be larger than any.
		if (size > budget && !(budget > 0 && _due_chunks.empty() && _due_fragments.empty() && _congestion.is_validated())) {
			return;
		}
		budget -= std::min(size, budget);
		_due_chunks.push_back(number);
		_unsent = std::max(_unsent, number + 1);
		if (is_due(sent, time)) {
			mark_due(sent, size, time);
		} else {
			packet += size;
			sent.is_paired = true;
			mark_sent(sent, size, time);
		}
	}
}

bool Delivery::is_losing_snapshot() const {
	constexpr double LARGE_PART = 0.3;
	constexpr ptrdiff_t MIN_REPEATED = 4; // fewer may be chance
	return _congestion.recent_loss() > LARGE_PART && std::count_if(_fragments.begin(), _fragments.end(), [](const Sent &sent) { return sent.times > 1; }) >= MIN_REPEATED;
}

void Delivery::make_room(uint32_t end) {
	size_t count = _sent.size();
	while (count < end - _first_missing) {
		count *= 2;
	}
	if (count == _sent.size()) {
		return;
	}
	std::vector<Sent> table(count);
	for (uint32_t number = _first_missing; number < _unsent; ++number) {
		table[number & (count - 1)] = sent(number);
	}
	_sent.swap(table);
}

/// Requests a snapshot if the receiver lacks chunks that the ring no longer has, or so many that a snapshot is smaller.
void Delivery::request_if_late(const ChunkRing &ring, double time) {
	if (_first_missing < ring.oldest()) {
		_needs_snapshot = true;
		return;
	}
	if (_first_missing == ring.next() || !_fragments.empty() || !_congestion.is_validated()) {
		return;
	}
	const Sent &oldest = sent(_first_missing);
	const bool is_stuck = _first_missing < _unsent && oldest.rounds > MAX_RETRANSMISSIONS && time - oldest.first > STUCK_TIME;
	const bool is_late = backlog(ring) > 0 && double(ring.bytes_from(_unsent)) > ring.rate() * STUCK_TIME;
	if ((is_stuck || is_late) && ring.bytes_from(_first_missing) > WORTHWHILE * _snapshot_size) {
		request_snapshot(time);
	}
}

void Delivery::accept(const PacketContent &acks, const ChunkRing &ring, double time) {
	_heard = time;
	_acknowledged = 0;
	_sample = 0.0;
	for (const AckItem &ack : acks.acks) {
		take_ack(ack, ring, time);
	}
	for (const SnapshotAckItem &ack : acks.snapshot_acks) {
		take_snapshot_ack(ack, time);
	}
	if (_acknowledged > 0) {
		_congestion.acknowledged(_acknowledged, _sample, time);
	}
	if (acks.requests_snapshot) {
		request_snapshot(time);
	}
}

void Delivery::take_ack(const AckItem &ack, const ChunkRing &ring, double time) {
	_meter.reported(ack.packets, time - _round_trip);
	const uint32_t ahead = uint16_t(ack.next - uint16_t(_first_missing));
	if (_needs_snapshot || _first_missing < ring.oldest() || ahead > _unsent - _first_missing) {
		return; // stale, or from another stream
	}
	if (!_fragments.empty() && ahead == 0 && ack.later.size() == 0) {
		return; // snapshot fragments are acknowledged separately
	}
	const uint32_t next = _first_missing + ahead;
	// The newest chunk caused this acknowledgement. Others may have arrived earlier, if an acknowledgement was lost.
	uint32_t end = next; // after the newest
	ack.later.visit([&](uint32_t, uint32_t run_end) { end = next + run_end; });
	if (end > _unsent) {
		return;
	}
	const bool has_waited = !_fragments.empty(); // for the snapshot, so that the time is no round trip
	ack.later.visit([&](uint32_t run_begin, uint32_t run_end) {
		for (uint32_t number = next + run_begin; number < next + run_end; ++number) {
			arrived(sent(number), time, number + 1 == end && !has_waited);
		}
	});
	for (uint32_t number = _first_missing; number < next; ++number) {
		arrived(sent(number), time, number + 1 == end && !has_waited);
	}
	_first_missing = next;
	while (_first_missing < _unsent && sent(_first_missing).arrived) {
		++_first_missing;
	}
	if (ahead > 0) {
		// A receiver acknowledges chunks in order only once it has the snapshot.
		finish_snapshot();
	}
}

void Delivery::take_snapshot_ack(const SnapshotAckItem &ack, double time) {
	if (_snapshot == nullptr || ack.snapshot != _snapshot->number) {
		return;
	}
	size_t end = std::min<size_t>(ack.next, _fragments.size()); // after the newest
	ack.later.visit([&](uint32_t, uint32_t run_end) { end = std::min<size_t>(ack.next + run_end, _fragments.size()); });
	const auto take = [&](size_t run_begin, size_t run_end) {
		for (size_t i = run_begin; i < std::min(run_end, _fragments.size()); ++i) {
			_fragment_time = !_fragments[i].arrived ? time : _fragment_time;
			arrived(_fragments[i], time, i + 1 == end);
		}
	};
	take(0, ack.next);
	ack.later.visit([&](uint32_t run_begin, uint32_t run_end) { take(ack.next + run_begin, ack.next + run_end); });
	if (std::all_of(_fragments.begin(), _fragments.end(), [](const Sent &sent) { return sent.arrived; })) {
		finish_snapshot();
	}
}

void Delivery::arrived(Sent &sent, double time, bool is_newest) {
	if (sent.arrived || sent.times == 0) {
		return;
	}
	sent.arrived = true;
	_acknowledged += sent.in_flight;
	_congestion.left(sent.in_flight);
	sent.in_flight = 0;
	// Karn's algorithm: a retransmitted chunk gives no round-trip sample, unless its acknowledgement comes too soon to belong to
	// the retransmission, and not long after the first. A long run of ambiguous ones means that the RTO is too short: most belong to the
	// first transmission.
	if (is_newest) {
		const double sample = std::max(time - sent.first, 1e-4);
		const bool is_plausible = sent.times == 1 || sample < MAX_AMBIGUOUS_SAMPLE;
		const bool is_unambiguous = sent.times == 1 || (is_plausible && time - sent.second < (sent.rounds == 1 ? 0.8 : 0.5) * _round_trip);
		_ambiguous = is_unambiguous ? 0 : _ambiguous + (is_plausible ? 1 : 0);
		if (is_plausible && _ambiguous == MAX_AMBIGUOUS) {
			_ambiguous = 0;
			_round_trip = 0.0;
		}
		if (is_unambiguous || (is_plausible && _round_trip == 0.0)) {
			_sample = sample;
			measure(_sample);
		}
	}
	_prior_loss -= _prior_loss * LOSS_WEIGHT;
	if (!sent.lost) {
		_loss -= _loss * LOSS_WEIGHT;
	}
}

void Delivery::measure(double round_trip) {
	_samples = std::min(_samples + 1, FIRST_SAMPLES);
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
