#include "net/delivery/delivery.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

constexpr double INITIAL_RTO = 0.2; // seconds, before a round trip is known
constexpr double MIN_RTO = 0.03;
constexpr double MIN_DEVIATION = 0.005; // frames and ticks at both ends
constexpr double MAX_RTO = 0.5; // but where the round trip is longer
/// A receiver that lacks a chunk after so many repeats, or so many chunks, gets a whole state instead.
constexpr int MAX_REPEATS = 8;
constexpr int PROMPT_REPEATS = 3;
constexpr double STUCK_TIME = 1.5; // seconds: a longer round trip than expected is none
constexpr uint32_t MAX_CHUNKS_BEHIND = 100;
/// While a state is on its way to it, it may be so many behind; chunks before these are not there any more.
constexpr uint32_t MAX_CHUNKS_KEPT = 200;
/// A state is not made again sooner than this.
constexpr double STATE_PAUSE = 0.5;
/// How much loss above this shortens the wait for an answer.
constexpr double MUCH_LOSS = 0.15;
constexpr double HASTE = 4.0;
/// After so many answers of which none is certainly one to a first try, the next is taken for one.
constexpr int MAX_UNCERTAIN = 8;
/// How much a chunk counts in the estimate of loss.
constexpr double LOSS_WEIGHT = 1.0 / 32.0;

} // namespace

void Delivery::want_state(double time) {
	if (time - _state_made >= STATE_PAUSE) {
		_needs_state = true;
		_state_made = time;
	}
}

void Delivery::start_state(std::shared_ptr<const StateSnapshot> state) {
	_needs_state = false;
	_state = std::move(state);
	_parts.assign(_state->parts(), Sent());
	_first_missing = _state->next_chunk;
	_sent_until = _state->next_chunk;
}

double Delivery::patience() const {
	const double most = std::max(MAX_RTO, 1.25 * _round_trip);
	return _round_trip > 0.0 ? std::clamp(_round_trip + 4.0 * std::max(_deviation, MIN_DEVIATION), MIN_RTO, most) : INITIAL_RTO;
}

void Delivery::collect_due(const ChunkRing &ring, double time) {
	_due_parts.clear();
	_due_chunks.clear();
	if (_needs_state) {
		return;
	}
	const double wait = patience();
	// Where much is lost, waiting for the answer to each try takes too long.
	const double haste = std::clamp(1.0 - HASTE * (_loss - MUCH_LOSS), 0.25, 1.0);
	const auto is_due = [&](Sent &sent) {
		if (sent.arrived) {
			return false;
		}
		if (sent.times == 0) {
			sent.first = time;
		} else if (!sent.missed && time - sent.first >= wait) {
			sent.missed = true;
			_loss += (1.0 - _loss) * LOSS_WEIGHT;
		}
		// After some repeats, each waits longer than the one before.
		if (sent.times > 0 && time - sent.time < wait * haste * std::clamp(sent.times - PROMPT_REPEATS, 1, 4)) {
			return false;
		}
		_repeated += sent.times > 0 ? 1 : 0;
		sent.times = uint8_t(std::min<int>(sent.times + 1, 255));
		sent.time = time;
		return true;
	};
	for (size_t i = 0; i < _parts.size(); ++i) {
		if (is_due(_parts[i])) {
			_due_parts.push_back(uint16_t(i));
		}
	}
	_sent_until = std::max(_sent_until, ring.next() > ChunkRing::RING ? ring.next() - ChunkRing::RING : 0);
	for (; _sent_until < ring.next(); ++_sent_until) {
		_sent[_sent_until % ChunkRing::RING] = Sent();
	}
	const uint32_t behind = ring.next() - _first_missing;
	if (behind > MAX_CHUNKS_KEPT) {
		want_state(time);
		return;
	}
	const bool is_far_behind = _parts.empty() && behind > MAX_CHUNKS_BEHIND;
	for (uint32_t number = _first_missing; number < ring.next(); ++number) {
		Sent &sent = _sent[number % ChunkRing::RING];
		if (is_due(sent)) {
			_due_chunks.push_back(number);
		}
	}
	const Sent &oldest = _sent[_first_missing % ChunkRing::RING];
	const bool is_stuck = _parts.empty() && _first_missing < ring.next() && oldest.times > MAX_REPEATS && time - oldest.first > STUCK_TIME;
	if (is_far_behind || is_stuck) {
		want_state(time);
	}
}

void Delivery::accept(const PacketContent &answer, const ChunkRing &ring, double time) {
	_heard = time;
	for (const AckItem &ack : answer.acks) {
		take_ack(ack, ring, time);
	}
	for (const StateAckItem &ack : answer.state_acks) {
		take_state_ack(ack);
	}
	if (answer.wants_state) {
		want_state(time);
	}
}

void Delivery::take_ack(const AckItem &ack, const ChunkRing &ring, double time) {
	const uint8_t ahead = uint8_t(ack.next - uint8_t(_first_missing));
	if (_needs_state || ring.next() - _first_missing > MAX_CHUNKS_KEPT || ahead > ring.next() - _first_missing) {
		return; // an old one, or of another stream
	}
	if (_state != nullptr && ack.next == uint8_t(_first_missing) && ack.later == 0 && !_parts.empty()) {
		return; // the state itself is acknowledged by its parts
	}
	const uint32_t next = _first_missing + ahead;
	// The newest chunk is what the receiver answered to; others may be told again, as an answer got lost.
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
		// Chunks are only counted in order once the state is there.
		_state.reset();
		_parts.clear();
	}
}

bool Delivery::can_be_short(uint32_t number) const {
	// At the first try the receiver lacks this chunk, and none before the first missing one: it must be one of a few.
	return _state == nullptr && _sent[number % ChunkRing::RING].times == 1 && number - _first_missing < ChunkItem::SHORT_REACH;
}

void Delivery::take_state_ack(const StateAckItem &ack) {
	if (_state == nullptr || ack.state != _state->number) {
		return;
	}
	bool complete = true;
	for (size_t i = 0; i < _parts.size(); ++i) {
		const size_t after = i - ack.next - 1;
		_parts[i].arrived = _parts[i].arrived || i < ack.next || (i > ack.next && after < 32 && ((ack.later >> after) & 1) != 0);
		complete = complete && _parts[i].arrived;
	}
	if (complete) {
		_state.reset();
		_parts.clear();
	}
}

void Delivery::chunk_arrived(uint32_t number, double time, bool is_newest) {
	Sent &sent = _sent[number % ChunkRing::RING];
	if (sent.arrived || sent.times == 0) {
		return;
	}
	sent.arrived = true;
	// An answer that comes too soon for the second try is one to the first. Where no answer is certain for long, the wait
	// for it is too short, and most are to the first.
	if (is_newest) {
		const bool is_certain = sent.times == 1 || (sent.times == 2 && time - sent.time < 0.5 * _round_trip);
		_uncertain = is_certain ? 0 : _uncertain + 1;
		if (_uncertain == MAX_UNCERTAIN) {
			_uncertain = 0;
			_round_trip = 0.0;
		}
		if (is_certain || _round_trip == 0.0) {
			measure(std::max(time - sent.first, 1e-4));
		}
	}
	_caution -= _caution * LOSS_WEIGHT;
	if (!sent.missed) {
		_loss -= _loss * LOSS_WEIGHT;
	}
}

void Delivery::measure(double round_trip) {
	// Jacobson, "Congestion avoidance and control", 1988.
	if (_round_trip == 0.0) {
		_round_trip = round_trip;
		_deviation = 0.5 * round_trip;
		return;
	}
	_deviation += (std::fabs(round_trip - _round_trip) - _deviation) / 4.0;
	_round_trip += (round_trip - _round_trip) / 8.0;
}

} // namespace net
