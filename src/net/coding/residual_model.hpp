#pragma once

#include "net/coding/range_coder.hpp"

#include <cstdint>
#include <cstdlib>

namespace net {

/// The recent mean of the magnitude of integers, in 1/256; what is expected of the next one.
class MeanMagnitude {
public:
	constexpr explicit MeanMagnitude(int32_t start) :
			_mean(start) {}

	void add(int32_t value) {
		const int32_t magnitude = value < 0 ? -value : value;
		_mean += ((magnitude < MAX ? magnitude : MAX) * 256 - _mean) / 8;
	}
	[[nodiscard]] int32_t value() const { return _mean; }
	void set_value(int32_t mean) { _mean = mean; }

	static constexpr int32_t MAX = 1024;

private:
	int32_t _mean;
};

/// Codes integers around zero as bits of their own probabilities: is it zero, its sign, then "is it larger" up to
/// UNARY, then an exponential Golomb code. The probabilities are kept apart by the magnitude that is expected, and
/// begin as those of the two-sided geometric distribution of that mean.
class ResidualModel {
public:
	static constexpr int LEVELS = 14;
	static constexpr int UNARY = 11;
	static constexpr int GOLOMB = 22;
	static constexpr int32_t LIMIT = 1 << 21; ///< of what decodes, whatever the bytes

	ResidualModel();

	/// `Coder` is a RangeEncoder, a RangeDecoder, which sets `value`, or a CostMeter. `expected` in 1/256.
	template <class Coder>
	void code(Coder &coder, int32_t &value, int32_t expected) {
		const int level = level_of(expected);
		bool zero = value == 0;
		coder.bit(_zero[level], zero);
		if (zero) {
			value = 0;
			return;
		}
		uint32_t negative = value < 0 ? 1 : 0;
		coder.bits(negative, 1);
		const uint32_t magnitude = uint32_t(value < 0 ? -value : value);
		uint32_t coded = 1;
		bool more = true;
		for (; coded <= UNARY; ++coded) {
			more = magnitude > coded;
			coder.bit(_more[level][coded - 1], more);
			if (!more) {
				break;
			}
		}
		if (more) {
			const uint32_t rest = magnitude - UNARY; // 1 or more
			int exponent = 0;
			for (; exponent < GOLOMB - 1; ++exponent) {
				bool longer = (rest >> (exponent + 1)) != 0;
				coder.bit(_golomb[exponent], longer);
				if (!longer) {
					break;
				}
			}
			uint32_t low = rest & ((1u << exponent) - 1);
			coder.bits(low, exponent);
			coded = UNARY + (1u << exponent) + low;
		}
		coded = coded < LIMIT ? coded : LIMIT;
		value = negative != 0 ? -int32_t(coded) : int32_t(coded);
	}

	/// All probabilities, for sending a model.
	template <class Visit>
	void visit(Visit &&visit) {
		for (int level = 0; level < LEVELS; ++level) {
			visit(_zero[level]);
			for (AdaptiveBit &bit : _more[level]) {
				visit(bit);
			}
		}
		for (AdaptiveBit &bit : _golomb) {
			visit(bit);
		}
	}

private:
	static int level_of(int32_t expected);

	AdaptiveBit _zero[LEVELS];
	AdaptiveBit _more[LEVELS][UNARY];
	AdaptiveBit _golomb[GOLOMB];
};

} // namespace net
