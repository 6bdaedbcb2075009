#include "net/coding/residual_model.hpp"

#include <cmath>

namespace net {

namespace {

/// Expected magnitudes in 1/256: each a little over 1.6 times the one before.
constexpr int32_t LEVEL_MEANS[ResidualModel::LEVELS] = { 16, 26, 43, 70, 115, 188, 308, 505, 828, 1357, 2225, 3649, 5984, 9813 };

/// The probability that a bit is 0, in 1/65536.
uint16_t probability(double p) {
	return uint16_t(std::floor(p * 65535.0));
}

} // namespace

ResidualModel::ResidualModel() {
	for (int level = 0; level < LEVELS; ++level) {
		// With P(k) proportional to r^|k|, the mean of |k| is m = 2 r / (1 - r^2).
		const double mean = LEVEL_MEANS[level] / 256.0;
		const double r = (std::sqrt(1.0 + mean * mean) - 1.0) / mean;
		_zero[level] = AdaptiveBit(probability(1.0 - (1.0 - r) / (1.0 + r)));
		for (AdaptiveBit &bit : _more[level]) {
			bit = AdaptiveBit(probability(1.0 - r));
		}
	}
}

int ResidualModel::level_of(int32_t expected) {
	// The means between two levels belong to the one that is nearer by ratio: the border is about 1.28 times the lower.
	int level = 0;
	while (level < LEVELS - 1 && expected * 4 > LEVEL_MEANS[level] * 5) {
		++level;
	}
	return level;
}

} // namespace net
