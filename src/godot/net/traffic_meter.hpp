#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace ga_godot {

/// Bytes and packets a second, over the last second.
class TrafficMeter {
public:
	void add(uint64_t p_bytes, double p_now) {
		turn_to(p_now);
		Slot &slot = _slots[size_t(_current % SLOTS)];
		slot.bytes += p_bytes;
		slot.packets++;
	}
	double get_bytes_per_second(double p_now) { return sum(p_now, &Slot::bytes); }
	double get_packets_per_second(double p_now) { return sum(p_now, &Slot::packets); }

private:
	struct Slot {
		uint64_t bytes = 0;
		uint64_t packets = 0;
	};

	static constexpr int64_t SLOTS_PER_SECOND = 8;
	static constexpr int64_t SLOTS = SLOTS_PER_SECOND + 1; // those of a second, and the one being filled

	void turn_to(double p_now) {
		const int64_t wanted = int64_t(std::floor(p_now * SLOTS_PER_SECOND));
		if (wanted - _current >= SLOTS) {
			_current = wanted - SLOTS;
		}
		while (_current < wanted) {
			_current++;
			_slots[size_t(_current % SLOTS)] = Slot();
		}
	}

	double sum(double p_now, uint64_t Slot::*p_member) {
		turn_to(p_now);
		uint64_t total = 0;
		for (int64_t i = 1; i < SLOTS; i++) {
			total += _slots[size_t((_current + i) % SLOTS)].*p_member;
		}
		return double(total);
	}

	std::array<Slot, size_t(SLOTS)> _slots;
	int64_t _current = 0;
};

} // namespace ga_godot
