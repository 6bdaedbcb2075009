#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace net {

/// Measures bytes and packets per second over the last second.
class TrafficMeter {
public:
	void add(uint64_t bytes, double now) {
		advance_to(now);
		Slot &slot = _slots[size_t(_current % SLOTS)];
		slot.bytes += bytes;
		slot.packets++;
	}
	double bytes_per_second(double now) { return sum(now, &Slot::bytes); }
	double packets_per_second(double now) { return sum(now, &Slot::packets); }

private:
	struct Slot {
		uint64_t bytes = 0;
		uint64_t packets = 0;
	};

	static constexpr int64_t SLOTS_PER_SECOND = 8;
	static constexpr int64_t SLOTS = SLOTS_PER_SECOND + 1; // one second of complete slots, and the slot being filled

	void advance_to(double now) {
		const int64_t wanted = int64_t(std::floor(now * SLOTS_PER_SECOND));
		_current = std::max(_current, wanted - SLOTS);
		while (_current < wanted) {
			_slots[size_t(++_current % SLOTS)] = Slot();
		}
	}

	double sum(double now, uint64_t Slot::*member) {
		advance_to(now);
		uint64_t total = 0;
		for (int64_t i = 1; i < SLOTS; i++) {
			total += _slots[size_t((_current + i) % SLOTS)].*member;
		}
		return double(total);
	}

	std::array<Slot, size_t(SLOTS)> _slots;
	int64_t _current = 0;
};

} // namespace net
