#include "net/coding/residual_model.hpp"

#include <cmath>

namespace net {

namespace {

/// Expected magnitude of each context, in units of 1/256. Each is about 1.6 times the previous one.
constexpr int32_t CONTEXT_MEANS[ResidualModel::CONTEXTS] = { 16, 26, 43, 70, 115, 188, 308, 505, 828, 1357, 2225, 3649, 5984, 9813 };

/// The probability that a bit is 0, in 1/65536.
uint16_t probability(double p) {
	return uint16_t(std::floor(p * 65535.0));
}

} // namespace

ResidualModel::ResidualModel() {
	for (int context = 0; context < CONTEXTS; ++context) {
		// With P(k) proportional to r^|k|, the mean of |k| is m = 2 r / (1 - r^2).
		const double mean = CONTEXT_MEANS[context] / 256.0;
		const double r = (std::sqrt(1.0 + mean * mean) - 1.0) / mean;
		_is_zero[context] = AdaptiveBit(probability(1.0 - (1.0 - r) / (1.0 + r)));
		for (AdaptiveBit &bit : _is_larger[context]) {
			bit = AdaptiveBit(probability(1.0 - r));
		}
	}
}

int ResidualModel::context_of(int32_t expected) {
	// Select the context whose mean is nearest by ratio. The boundary is at 1.25 times the lower mean.
	int context = 0;
	while (context < CONTEXTS - 1 && expected * 4 > CONTEXT_MEANS[context] * 5) {
		++context;
	}
	return context;
}

} // namespace net
