#include "net/delivery/chunk_buffer.hpp"

#include <algorithm>

namespace net {

namespace {

/// Chunks may arrive in the wrong order by this many: the first one before a snapshot begins to arrive, and the snapshot itself.
constexpr uint16_t EARLY = 64;

} // namespace

void ChunkBuffer::empty(Slot &slot) {
	if (!slot.full) {
		return;
	}
	slot.full = false;
	_bytes -= slot.bytes.size();
	if (_spare.size() < MAX_SPARE) {
		_spare.emplace_back();
		_spare.back().swap(slot.bytes);
	} else {
		slot.bytes = std::vector<uint8_t>();
	}
}

void ChunkBuffer::skip_to(uint16_t next) {
	const auto forward = uint16_t(next - _next);
	const auto back = uint16_t(_next - next);
	if (_is_based && back > 0 && back <= EARLY) {
		grow(_end + back);
		_next = next;
		_end += _end > 0 ? back : 0;
	}
	const size_t dropped = _is_based && (forward < 0x8000 || next == _next) ? std::min<size_t>(uint16_t(next - _next), _end) : _end;
	for (size_t offset = 0; offset < dropped; ++offset) {
		if (is_full(offset)) {
			empty(slot(offset));
		}
	}
	_end -= dropped;
	_next = next;
	_is_based = true;
	_present = _windows = 0;
	_is_inside = false;
	_is_broken = false;
}

void ChunkBuffer::restart(uint16_t next) {
	skip_to(next);
	_is_started = true;
	extend();
}

void ChunkBuffer::expect(uint16_t next) {
	if (!_is_started) {
		skip_to(next);
		extend();
	}
}

void ChunkBuffer::forget() {
	skip_to(uint16_t(_next + 0x8000));
	_is_based = false;
	_is_started = false;
}

std::optional<uint16_t> ChunkBuffer::full_number(const ChunkItem &chunk) const {
	// Exactly one number within the reach of the first missing chunk has these low bits.
	const auto missing = uint16_t(_next + _present);
	if (chunk.is_wide) {
		return chunk.number;
	}
	if (!_is_started) {
		return std::nullopt;
	}
	const uint16_t reach = chunk.is_short ? ChunkItem::SHORT_REACH : ChunkItem::NARROW_REACH;
	const auto lowest = uint16_t(missing - reach);
	return uint16_t(lowest + ((chunk.number - lowest) & (2 * reach - 1)));
}

void ChunkBuffer::grow(size_t offset) {
	size_t count = _slots.size();
	while (count <= offset) {
		count *= 2;
	}
	if (count == _slots.size()) {
		return;
	}
	std::vector<Slot> slots(count);
	for (size_t i = 0; i < _slots.size(); ++i) {
		std::swap(slots[(size_t(_next) + i) & (count - 1)], slot(i));
	}
	_slots.swap(slots);
}

std::optional<uint16_t> ChunkBuffer::add(const ChunkItem &chunk) {
	const std::optional<uint16_t> number = full_number(chunk);
	if (!number) {
		return std::nullopt;
	}
	if (!_is_based) {
		_next = uint16_t(*number - EARLY);
		_is_based = true;
	}
	const size_t offset = uint16_t(*number - _next);
	// Room for the first missing chunk remains, as nothing can be taken without it.
	const size_t max_bytes = offset == _present ? MAX_BYTES + MAX_BYTES / 8 : MAX_BYTES;
	if (offset >= MAX_AHEAD || is_full(offset) || _bytes + chunk.size > max_bytes) {
		return std::nullopt;
	}
	grow(offset);
	Slot &added = slot(offset);
	added.full = true;
	added.first = chunk.first;
	added.last = chunk.last;
	added.check = { chunk.check, uint8_t(chunk.is_short ? 7 : 255) };
	if (!_spare.empty()) {
		added.bytes.swap(_spare.back());
		_spare.pop_back();
	}
	added.bytes.assign(chunk.bytes, chunk.bytes + chunk.size);
	_bytes += chunk.size;
	_end = std::max(_end, offset + 1);
	extend();
	return number;
}

void ChunkBuffer::extend() {
	for (; is_full(_present); ++_present) {
		const Slot &next = slot(_present);
		_is_broken = _is_broken || next.first == _is_inside;
		_is_inside = !next.last;
		_windows += next.last ? 1 : 0;
	}
}

std::optional<WindowCheck> ChunkBuffer::take_window(std::vector<uint8_t> &window) {
	if (!_is_started || _is_broken || _windows == 0) {
		return std::nullopt;
	}
	window.clear();
	WindowCheck check;
	for (bool is_last = false; !is_last;) {
		Slot &next = slot(0);
		window.insert(window.end(), next.bytes.begin(), next.bytes.end());
		is_last = next.last;
		check = next.check;
		empty(next);
		++_next;
		--_present;
		--_end;
	}
	--_windows;
	return check;
}

AckItem ChunkBuffer::ack() const {
	AckItem ack;
	ack.next = uint16_t(_next + _present);
	for (size_t offset = _present; offset < _end;) {
		const size_t gap = offset;
		while (offset < _end && !is_full(offset)) {
			++offset;
		}
		const size_t begin = offset;
		while (offset < _end && is_full(offset)) {
			++offset;
		}
		ack.later.add(uint16_t(begin - gap), uint16_t(offset - begin));
	}
	return ack;
}

} // namespace net
