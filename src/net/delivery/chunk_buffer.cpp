#include "net/delivery/chunk_buffer.hpp"

namespace net {

void ChunkBuffer::empty(Slot &slot) {
	if (slot.full) {
		slot.full = false;
		spare_.emplace_back();
		spare_.back().swap(slot.bytes);
	}
}

void ChunkBuffer::restart(std::uint8_t next) {
	// What came before the state, and belongs behind it, is kept. What waited for its turn before `next` is not: its
	// numbers will be used again.
	const std::uint8_t forward = std::uint8_t(next - next_);
	const int skipped = started_ && forward < 256 - AHEAD / 2 ? forward : 0;
	for (int i = 0; i < 256; ++i) {
		if (i >= AHEAD || i + skipped >= 256) {
			empty(slots_[std::uint8_t(next + i)]);
		}
	}
	next_ = next;
	started_ = true;
	broken_ = false;
}

void ChunkBuffer::forget() {
	for (Slot &slot : slots_) {
		empty(slot);
	}
	started_ = false;
	broken_ = false;
}

bool ChunkBuffer::add(const ChunkItem &chunk, std::uint8_t &number) {
	number = chunk.number;
	if (chunk.is_short) {
		// Of the numbers with these low bits the one in reach.
		const std::uint8_t lowest = std::uint8_t(first_missing() - ChunkItem::SHORT_REACH);
		number = std::uint8_t(lowest + ((chunk.number - lowest) & 15));
	}
	Slot &slot = slots_[number];
	if (slot.full || (started_ ? std::uint8_t(number - next_) >= AHEAD : chunk.is_short)) {
		return false;
	}
	slot.full = true;
	slot.first = chunk.first;
	slot.last = chunk.last;
	slot.check = chunk.check;
	slot.check_mask = chunk.is_short ? 7 : 255;
	if (!spare_.empty()) {
		slot.bytes.swap(spare_.back());
		spare_.pop_back();
	}
	slot.bytes.assign(chunk.bytes, chunk.bytes + chunk.size);
	return true;
}

bool ChunkBuffer::take_window(std::vector<std::uint8_t> &window, std::uint8_t &check, std::uint8_t &check_mask) {
	if (!started_ || broken_) {
		return false;
	}
	int count = 0;
	for (bool last = false; !last; ++count) {
		const Slot &slot = slots_[std::uint8_t(next_ + count)];
		if (count == AHEAD || !slot.full) {
			return false;
		}
		if (slot.first != (count == 0)) {
			broken_ = true;
			return false;
		}
		last = slot.last;
	}
	window.clear();
	for (int i = 0; i < count; ++i) {
		Slot &slot = slots_[next_++];
		window.insert(window.end(), slot.bytes.begin(), slot.bytes.end());
		check = slot.check;
		check_mask = slot.check_mask;
		empty(slot);
	}
	return true;
}

std::uint8_t ChunkBuffer::first_missing() const {
	std::uint8_t number = next_;
	do {
		if (!slots_[number].full) {
			return number;
		}
		++number;
	} while (number != next_);
	return number;
}

AckItem ChunkBuffer::ack() const {
	AckItem ack;
	ack.next = first_missing();
	for (int bit = 0; bit < 64; ++bit) {
		const std::uint8_t number = std::uint8_t(ack.next + 1 + bit);
		if (slots_[number].full && std::uint8_t(number - next_) < AHEAD) {
			ack.later |= std::uint64_t(1) << bit;
		}
	}
	return ack;
}

} // namespace net
