#pragma once

#include "net/coding/range_coder.hpp"

#include <cstdint>
#include <cstdlib>

namespace net {

/// An exponential moving average of integer magnitudes, in units of 1/256. It predicts the magnitude of the next integer.
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

	ResidualModel();

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
		const uint32_t magnitude = uint32_t(value < 0 ? -value : value);
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
		coded = coded < MAX_MAGNITUDE ? coded : MAX_MAGNITUDE;
		value = negative != 0 ? -int32_t(coded) : int32_t(coded);
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
	static int context_of(int32_t expected);

	AdaptiveBit _is_zero[CONTEXTS];
	AdaptiveBit _is_larger[CONTEXTS][MAX_UNARY];
	AdaptiveBit _is_longer[MAX_EXPONENT];
};

} // namespace net
