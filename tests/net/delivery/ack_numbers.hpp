#pragma once

#include "net/delivery/packet.hpp"

#include <cstdint>
#include <vector>

namespace net {

using AckNumbers = std::vector<uint32_t>;

/// The runs that report the numbers, which are relative to the first missing one and ascending.
inline AckRuns ack_runs(const AckNumbers &numbers) {
	AckRuns runs;
	uint32_t at = 0;
	for (size_t i = 0; i < numbers.size();) {
		size_t end = i + 1;
		while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) {
			++end;
		}
		runs.add(uint16_t(numbers[i] - at), uint16_t(end - i));
		at = numbers[end - 1] + 1;
		i = end;
	}
	return runs;
}

/// The inverse of ack_runs.
inline AckNumbers ack_numbers(const AckRuns &runs) {
	AckNumbers numbers;
	runs.visit([&](uint32_t begin, uint32_t end) {
		for (uint32_t number = begin; number < end; ++number) {
			numbers.push_back(number);
		}
	});
	return numbers;
}

} // namespace net
