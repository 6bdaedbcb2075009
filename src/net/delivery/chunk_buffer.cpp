#include "net/delivery/chunk_buffer.hpp"

namespace net {

void ChunkBuffer::empty(Slot &slot) {
	if (slot.full) {
		slot.full = false;
		_spare.emplace_back();
		_spare.back().swap(slot.bytes);
	}
}

void ChunkBuffer::restart(uint8_t next) {
	// Chunks after the snapshot may have arrived before it: keep them. Drop chunks before `next`, as their numbers will be
	// reused.
	const uint8_t forward = uint8_t(next - _next);
	const int skipped = _started && forward < 256 - AHEAD / 2 ? forward : 0;
	for (int i = 0; i < 256; ++i) {
		if (i >= AHEAD || i + skipped >= 256) {
			empty(_slots[uint8_t(next + i)]);
		}
	}
	_next = next;
	_started = true;
	_broken = false;
}

void ChunkBuffer::forget() {
	for (Slot &slot : _slots) {
		empty(slot);
	}
	_started = false;
	_broken = false;
}

std::optional<uint8_t> ChunkBuffer::add(const ChunkItem &chunk) {
	uint8_t number = chunk.number;
	if (chunk.is_short) {
		// Exactly one number within SHORT_REACH of the first missing chunk has these low bits.
		const uint8_t lowest = uint8_t(first_missing() - ChunkItem::SHORT_REACH);
		number = uint8_t(lowest + ((chunk.number - lowest) & 15));
	}
	Slot &slot = _slots[number];
	if (slot.full || (_started ? uint8_t(number - _next) >= AHEAD : chunk.is_short)) {
		return std::nullopt;
	}
	slot.full = true;
	slot.first = chunk.first;
	slot.last = chunk.last;
	slot.check = { chunk.check, uint8_t(chunk.is_short ? 7 : 255) };
	if (!_spare.empty()) {
		slot.bytes.swap(_spare.back());
		_spare.pop_back();
	}
	slot.bytes.assign(chunk.bytes, chunk.bytes + chunk.size);
	return number;
}

std::optional<WindowCheck> ChunkBuffer::take_window(std::vector<uint8_t> &window) {
	if (!_started || _broken) {
		return std::nullopt;
	}
	int count = 0;
	for (bool last = false; !last; ++count) {
		const Slot &slot = _slots[uint8_t(_next + count)];
		if (count == AHEAD || !slot.full) {
			return std::nullopt;
		}
		if (slot.first != (count == 0)) {
			_broken = true;
			return std::nullopt;
		}
		last = slot.last;
	}
	window.clear();
	WindowCheck check;
	for (int i = 0; i < count; ++i) {
		Slot &slot = _slots[_next++];
		window.insert(window.end(), slot.bytes.begin(), slot.bytes.end());
		check = slot.check;
		empty(slot);
	}
	return check;
}

uint8_t ChunkBuffer::first_missing() const {
	int count = 0;
	while (count < 256 && _slots[uint8_t(_next + count)].full) {
		++count;
	}
	return uint8_t(_next + count);
}

AckItem ChunkBuffer::ack() const {
	AckItem ack;
	ack.next = first_missing();
	for (int bit = 0; bit < 64; ++bit) {
		const uint8_t number = uint8_t(ack.next + 1 + bit);
		if (_slots[number].full && uint8_t(number - _next) < AHEAD) {
			ack.later |= uint64_t(1) << bit;
		}
	}
	return ack;
}

} // namespace net
