#include "net/delivery/delivery.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

constexpr double FIRST_PATIENCE = 0.2; // seconds, before a round trip is known
constexpr double LEAST_PATIENCE = 0.03;
constexpr double LEAST_DEVIATION = 0.005; // frames and ticks at both ends
constexpr double MOST_PATIENCE = 0.5; // but where the round trip is longer
/// A receiver that lacks a chunk after so many repeats, or so many chunks, gets a whole state instead.
constexpr int MOST_REPEATS = 8;
constexpr int PROMPT_REPEATS = 3;
constexpr double STUCK_TIME = 1.5; // seconds: a longer round trip than expected is none
constexpr std::uint32_t MOST_CHUNKS_BEHIND = 100;
/// While a state is on its way to it, it may be so many behind; chunks before these are not there any more.
constexpr std::uint32_t MOST_CHUNKS_KEPT = 200;
/// A state is not made again sooner than this.
constexpr double STATE_PAUSE = 0.5;
/// How much loss above this shortens the wait for an answer.
constexpr double MUCH_LOSS = 0.15;
constexpr double HASTE = 4.0;
/// After so many answers of which none is certainly one to a first try, the next is taken for one.
constexpr int MOST_UNCERTAIN = 8;
/// How much a chunk counts in the estimate of loss.
constexpr double LOSS_WEIGHT = 1.0 / 32.0;

} // namespace

void Delivery::want_state(double time) {
	if (time - state_made_ >= STATE_PAUSE) {
		needs_state_ = true;
		state_made_ = time;
	}
}

void Delivery::start_state(std::shared_ptr<const StateSnapshot> state) {
	needs_state_ = false;
	state_ = std::move(state);
	parts_.assign(state_->parts(), Sent());
	first_missing_ = state_->next_chunk;
	sent_until_ = state_->next_chunk;
}

double Delivery::patience() const {
	const double most = std::max(MOST_PATIENCE, 1.25 * round_trip_);
	return round_trip_ > 0.0 ? std::clamp(round_trip_ + 4.0 * std::max(deviation_, LEAST_DEVIATION), LEAST_PATIENCE, most) : FIRST_PATIENCE;
}

void Delivery::collect_due(const ChunkRing &ring, double time) {
	due_parts_.clear();
	due_chunks_.clear();
	if (needs_state_) {
		return;
	}
	const double wait = patience();
	// Where much is lost, waiting for the answer to each try takes too long.
	const double haste = std::clamp(1.0 - HASTE * (loss_ - MUCH_LOSS), 0.25, 1.0);
	const auto is_due = [&](Sent &sent) {
		if (sent.arrived) {
			return false;
		}
		if (sent.times == 0) {
			sent.first = time;
		} else if (!sent.missed && time - sent.first >= wait) {
			sent.missed = true;
			loss_ += (1.0 - loss_) * LOSS_WEIGHT;
		}
		// After some repeats, each waits longer than the one before.
		if (sent.times > 0 && time - sent.time < wait * haste * std::clamp(sent.times - PROMPT_REPEATS, 1, 4)) {
			return false;
		}
		repeated_ += sent.times > 0 ? 1 : 0;
		sent.times = std::uint8_t(std::min<int>(sent.times + 1, 255));
		sent.time = time;
		return true;
	};
	for (std::size_t i = 0; i < parts_.size(); ++i) {
		if (is_due(parts_[i])) {
			due_parts_.push_back(std::uint16_t(i));
		}
	}
	sent_until_ = std::max(sent_until_, ring.next() > ChunkRing::RING ? ring.next() - ChunkRing::RING : 0);
	for (; sent_until_ < ring.next(); ++sent_until_) {
		sent_[sent_until_ % ChunkRing::RING] = Sent();
	}
	const std::uint32_t behind = ring.next() - first_missing_;
	if (behind > MOST_CHUNKS_KEPT) {
		want_state(time);
		return;
	}
	const bool is_far_behind = parts_.empty() && behind > MOST_CHUNKS_BEHIND;
	for (std::uint32_t number = first_missing_; number < ring.next(); ++number) {
		Sent &sent = sent_[number % ChunkRing::RING];
		if (is_due(sent)) {
			due_chunks_.push_back(number);
		}
	}
	const Sent &oldest = sent_[first_missing_ % ChunkRing::RING];
	const bool is_stuck = parts_.empty() && first_missing_ < ring.next() && oldest.times > MOST_REPEATS && time - oldest.first > STUCK_TIME;
	if (is_far_behind || is_stuck) {
		want_state(time);
	}
}

void Delivery::accept(const PacketContent &answer, const ChunkRing &ring, double time) {
	heard_ = time;
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
	const std::uint8_t ahead = std::uint8_t(ack.next - std::uint8_t(first_missing_));
	if (needs_state_ || ring.next() - first_missing_ > MOST_CHUNKS_KEPT || ahead > ring.next() - first_missing_) {
		return; // an old one, or of another stream
	}
	if (state_ != nullptr && ack.next == std::uint8_t(first_missing_) && ack.later == 0 && !parts_.empty()) {
		return; // the state itself is acknowledged by its parts
	}
	const std::uint32_t next = first_missing_ + ahead;
	// The newest chunk is what the receiver answered to; others may be told again, as an answer got lost.
	bool is_newest = true;
	for (int bit = 63; bit >= 0; --bit) {
		const std::uint32_t number = next + 1 + std::uint32_t(bit);
		if (((ack.later >> bit) & 1) != 0 && number < ring.next()) {
			chunk_arrived(number, time, is_newest);
			is_newest = false;
		}
	}
	for (std::uint32_t number = next; number-- > first_missing_;) {
		chunk_arrived(number, time, is_newest);
		is_newest = false;
	}
	first_missing_ = next;
	while (first_missing_ < ring.next() && first_missing_ < sent_until_ && sent_[first_missing_ % ChunkRing::RING].arrived) {
		++first_missing_;
	}
	if (ahead > 0) {
		// Chunks are only counted in order once the state is there.
		state_.reset();
		parts_.clear();
	}
}

bool Delivery::can_be_short(std::uint32_t number) const {
	// At the first try the receiver lacks this chunk, and none before the first missing one: it must be one of a few.
	return state_ == nullptr && sent_[number % ChunkRing::RING].times == 1 && number - first_missing_ < ChunkItem::SHORT_REACH;
}

void Delivery::take_state_ack(const StateAckItem &ack) {
	if (state_ == nullptr || ack.state != state_->number) {
		return;
	}
	bool complete = true;
	for (std::size_t i = 0; i < parts_.size(); ++i) {
		const std::size_t after = i - ack.next - 1;
		parts_[i].arrived = parts_[i].arrived || i < ack.next || (i > ack.next && after < 32 && ((ack.later >> after) & 1) != 0);
		complete = complete && parts_[i].arrived;
	}
	if (complete) {
		state_.reset();
		parts_.clear();
	}
}

void Delivery::chunk_arrived(std::uint32_t number, double time, bool is_newest) {
	Sent &sent = sent_[number % ChunkRing::RING];
	if (sent.arrived || sent.times == 0) {
		return;
	}
	sent.arrived = true;
	// An answer that comes too soon for the second try is one to the first. Where no answer is certain for long, the wait
	// for it is too short, and most are to the first.
	if (is_newest) {
		const bool is_certain = sent.times == 1 || (sent.times == 2 && time - sent.time < 0.5 * round_trip_);
		uncertain_ = is_certain ? 0 : uncertain_ + 1;
		if (uncertain_ == MOST_UNCERTAIN) {
			uncertain_ = 0;
			round_trip_ = 0.0;
		}
		if (is_certain || round_trip_ == 0.0) {
			measure(std::max(time - sent.first, 1e-4));
		}
	}
	caution_ -= caution_ * LOSS_WEIGHT;
	if (!sent.missed) {
		loss_ -= loss_ * LOSS_WEIGHT;
	}
}

void Delivery::measure(double round_trip) {
	// Jacobson, "Congestion avoidance and control", 1988.
	if (round_trip_ == 0.0) {
		round_trip_ = round_trip;
		deviation_ = 0.5 * round_trip;
		return;
	}
	deviation_ += (std::fabs(round_trip - round_trip_) - deviation_) / 4.0;
	round_trip_ += (round_trip - round_trip_) / 8.0;
}

} // namespace net
