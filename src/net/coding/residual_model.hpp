#pragma once

#include "net/coding/range_coder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace net {

/// An exponential moving average of integer magnitudes, in units of 1/256. It predicts the magnitude of the next integer.
class MeanMagnitude {
public:
	constexpr explicit MeanMagnitude(int32_t start) :
			_mean(start) {}

	void add(int32_t value) {
		_mean += (std::min(std::abs(value), MAX) * 256 - _mean) / 8;
	}
	[[nodiscard]] int32_t value() const { return _mean; }
	void set_value(int32_t mean) { _mean = mean; }

	static constexpr int32_t MAX = 1024; ///< larger magnitudes are clamped

private:
	int32_t _mean;
};

/// Codes a residual, an integer close to zero, as adaptive bits: "is zero", a plain sign bit, the magnitude in unary up to
/// MAX_UNARY, and the rest in an exponential Golomb code. The expected magnitude selects the context, that is,
/// the set of adaptive bits. The bits of a context are initialized to the two-sided geometric distribution with its mean.
class ResidualModel {
public:
	static constexpr int CONTEXTS = 14;
	static constexpr int MAX_UNARY = 11;
	static constexpr int MAX_EXPONENT = 22;
	static constexpr int32_t MAX_MAGNITUDE = 1 << 21; ///< of a decoded residual, even for malformed input

	ResidualModel() {
		const auto probability = [](double p) { return uint16_t(std::floor(p * 65535.0)); };
		for (int context = 0; context < CONTEXTS; ++context) {
			// With P(k) proportional to r^|k|, the mean of |k| is m = 2 r / (1 - r^2).
			const double mean = CONTEXT_MEANS[context] / 256.0;
			const double r = (std::sqrt(1.0 + mean * mean) - 1.0) / mean;
			_is_zero[context] = AdaptiveBit(probability(1.0 - (1.0 - r) / (1.0 + r)));
			std::fill_n(_is_larger[context], MAX_UNARY, AdaptiveBit(probability(1.0 - r)));
		}
	}

	/// `Coder` is a RangeEncoder, a RangeDecoder (which sets `value`) or a CostMeter. `expected` is the expected magnitude in
	/// units of 1/256.
	template <class Coder>
	void code(Coder &coder, int32_t &value, int32_t expected) {
		const int context = context_of(expected);
		bool zero = value == 0;
		coder.bit(_is_zero[context], zero);
		if (zero) {
			value = 0;
			return;
		}
		uint32_t negative = value < 0 ? 1 : 0;
		coder.bits(negative, 1);
		const auto magnitude = uint32_t(std::abs(value));
		uint32_t coded = 1;
		bool more = true;
		for (; coded <= MAX_UNARY; ++coded) {
			more = magnitude > coded;
			coder.bit(_is_larger[context][coded - 1], more);
			if (!more) {
				break;
			}
		}
		if (more) {
			const uint32_t rest = magnitude - MAX_UNARY; // 1 or more
			int exponent = 0;
			for (; exponent < MAX_EXPONENT - 1; ++exponent) {
				bool longer = (rest >> (exponent + 1)) != 0;
				coder.bit(_is_longer[exponent], longer);
				if (!longer) {
					break;
				}
			}
			uint32_t low = rest & ((1u << exponent) - 1);
			coder.bits(low, exponent);
			coded = MAX_UNARY + (1u << exponent) + low;
		}
		const int32_t bounded = std::min(int32_t(coded), MAX_MAGNITUDE);
		value = negative != 0 ? -bounded : bounded;
	}

	/// Visits all adaptive bits.
	template <class Visit>
	void visit(Visit &&visit) {
		for (int context = 0; context < CONTEXTS; ++context) {
			visit(_is_zero[context]);
			for (AdaptiveBit &bit : _is_larger[context]) {
				visit(bit);
			}
		}
		for (AdaptiveBit &bit : _is_longer) {
			visit(bit);
		}
	}

private:
	/// Expected magnitude of each context, in units of 1/256. Each is about 1.6 times the previous one.
	static constexpr int32_t CONTEXT_MEANS[CONTEXTS] = { 16, 26, 43, 70, 115, 188, 308, 505, 828, 1357, 2225, 3649, 5984, 9813 };

	static int context_of(int32_t expected) {
		// Select the context whose mean is nearest by ratio. The boundary is at 1.25 times the lower mean.
		int context = 0;
		while (context < CONTEXTS - 1 && expected * 4 > CONTEXT_MEANS[context] * 5) {
			++context;
		}
		return context;
	}

	AdaptiveBit _is_zero[CONTEXTS];
	AdaptiveBit _is_larger[CONTEXTS][MAX_UNARY];
	AdaptiveBit _is_longer[MAX_EXPONENT];
};

} // namespace net
