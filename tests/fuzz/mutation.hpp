#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace fuzz {

using Bytes = std::vector<uint8_t>;

/// Applies a random mutation: flipped bits, other bytes, truncation, insertion, noise.
inline void mutate(Bytes &bytes, std::mt19937 &random) {
	if (bytes.empty()) {
		bytes.push_back(uint8_t(random()));
		return;
	}
	switch (random() % 6) {
		case 0:
			bytes[random() % bytes.size()] ^= uint8_t(1u << (random() % 8));
			break;
		case 1:
			bytes[random() % bytes.size()] = uint8_t(random());
			break;
		case 2:
			bytes.resize(random() % bytes.size());
			break;
		case 3:
			bytes.insert(bytes.begin() + ptrdiff_t(random() % bytes.size()), 1 + random() % 20, uint8_t(random()));
			break;
		case 4:
			for (uint8_t &byte : bytes) {
				byte = uint8_t(random());
			}
			break;
		default:
			bytes[random() % std::min<size_t>(bytes.size(), 8)] = uint8_t(random() % 2 == 0 ? 0xff : 0);
	}
}

} // namespace fuzz
