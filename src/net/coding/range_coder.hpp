#pragma once

#include "net/coding/portable_math.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// An adaptive binary range coder (Martin, "Range encoding", 1979; 32-bit arithmetic and carry propagation as in LZMA), in
// integers only, so that all machines agree.

namespace net {

/// An adaptive binary model: estimates the probability that a bit is 0 as the mean of a fast and a slow running average.
class AdaptiveBit {
public:
	constexpr AdaptiveBit() = default;
	constexpr explicit AdaptiveBit(uint16_t zero) :
			_fast(zero), _slow(zero) {}

	/// The probability of 0, in units of 1/4096; range 16 to 4080.
	[[nodiscard]] uint32_t probability() const {
		const uint32_t mean = (uint32_t(_fast) + _slow) >> 5;
		return mean < 16 ? 16 : (mean > 4080 ? 4080 : mean);
	}

	void update(bool bit) {
		if (bit) {
			_fast = uint16_t(_fast - (_fast >> FAST));
			_slow = uint16_t(_slow - (_slow >> SLOW));
		} else {
			_fast = uint16_t(_fast + ((65535 - _fast) >> FAST));
			_slow = uint16_t(_slow + ((65535 - _slow) >> SLOW));
		}
	}

	/// Both averages, packed.
	[[nodiscard]] uint32_t state() const { return uint32_t(_fast) << 16 | _slow; }
	void set_state(uint32_t state) {
		_fast = uint16_t(state >> 16);
		_slow = uint16_t(state);
	}

private:
	// Adaptation rates, as shifts.
	static constexpr int FAST = 4;
	static constexpr int SLOW = 7;
	uint16_t _fast = 32768; // in 1/65536
	uint16_t _slow = 32768;
};

/// Appends coded bits to the caller's byte vector. The decoder reads zeros past the end, so `finish()` omits trailing zeros.
class RangeEncoder {
public:
	explicit RangeEncoder(std::vector<uint8_t> &bytes) :
			_bytes(bytes), _begin(bytes.size()) {}

	void bit(AdaptiveBit &model, bool value) {
		const uint32_t bound = (_range >> 12) * model.probability();
		if (value) {
			_low += bound;
			_range -= bound;
		} else {
			_range = bound;
		}
		model.update(value);
		renormalize();
	}

	/// Codes the low `count` bits of `value` with equal probabilities; 0 <= count <= 32.
	void bits(uint32_t value, int count) {
		for (int i = count - 1; i >= 0; --i) {
			_range >>= 1;
			if (((value >> i) & 1) != 0) {
				_low += _range;
			}
			renormalize();
		}
	}

	void finish() {
		// All values in [low, low + range) decode to the same bits. Choose the one with the most trailing zero bits.
		for (int k = 32; k >= 0; --k) {
			const uint64_t mask = (uint64_t(1) << k) - 1;
			const uint64_t candidate = (_low + mask) & ~mask;
			if (candidate < _low + _range) {
				_low = candidate;
				break;
			}
		}
		for (int i = 0; i < 5; ++i) {
			shift_low();
		}
		while (_bytes.size() > _begin && _bytes.back() == 0) {
			_bytes.pop_back();
		}
	}

private:
	void renormalize() {
		while (_range < (1u << 24)) {
			_range <<= 8;
			shift_low();
		}
	}

	void shift_low() {
		if (_low < 0xff000000u || _low >= (uint64_t(1) << 32)) {
			const uint8_t carry = uint8_t(_low >> 32);
			if (!_first) {
				_bytes.push_back(uint8_t(_cache + carry));
			}
			_first = false;
			for (; _pending > 0; --_pending) {
				_bytes.push_back(uint8_t(0xff + carry));
			}
			_cache = uint8_t(_low >> 24);
		} else {
			++_pending;
		}
		_low = (_low & 0x00ffffffu) << 8;
	}

	std::vector<uint8_t> &_bytes;
	size_t _begin;
	uint64_t _low = 0;
	uint32_t _range = 0xffffffffu;
	size_t _pending = 0; // number of 0xff bytes after _cache, through which a carry would propagate
	uint8_t _cache = 0; // the last byte that a carry may still increment
	bool _first = true; // the first byte is always 0 and is not written
};

/// Decodes the output of RangeEncoder. Past the end it reads zeros. Any bytes are safe input.
class RangeDecoder {
public:
	RangeDecoder(const uint8_t *bytes, size_t size) :
			_bytes(bytes), _size(size) {
		for (int i = 0; i < 4; ++i) {
			_code = _code << 8 | next();
		}
	}

	void bit(AdaptiveBit &model, bool &value) {
		const uint32_t bound = (_range >> 12) * model.probability();
		value = _code >= bound;
		if (value) {
			_code -= bound;
			_range -= bound;
		} else {
			_range = bound;
		}
		model.update(value);
		renormalize();
	}

	void bits(uint32_t &value, int count) {
		value = 0;
		for (int i = 0; i < count; ++i) {
			_range >>= 1;
			const bool one = _code >= _range;
			if (one) {
				_code -= _range;
			}
			value = value << 1 | uint32_t(one);
			renormalize();
		}
	}

	[[nodiscard]] uint32_t read_bits(int count) {
		uint32_t value = 0;
		bits(value, count);
		return value;
	}

	/// Number of bytes read past the end; more than 4 only if RangeEncoder did not write the input.
	[[nodiscard]] size_t overrun() const { return _overrun; }

private:
	uint8_t next() {
		if (_at < _size) {
			return _bytes[_at++];
		}
		++_overrun;
		return 0;
	}

	void renormalize() {
		while (_range < (1u << 24)) {
			_range <<= 8;
			_code = _code << 8 | next();
		}
	}

	const uint8_t *_bytes;
	size_t _size;
	size_t _at = 0;
	size_t _overrun = 0;
	uint32_t _range = 0xffffffffu;
	uint32_t _code = 0;
};

/// Sums the coding cost, in units of 1/256 bit, without adapting the models.
class CostMeter {
public:
	void bit(const AdaptiveBit &model, bool value) {
		const uint32_t zero = model.probability();
		_cost += table()[(value ? 4096 - zero : zero) >> 4];
	}
	void bits(uint32_t, int count) { _cost += uint32_t(count) << 8; }
	[[nodiscard]] uint32_t cost() const { return _cost; }

private:
	/// -256 log2(p / 256) for p = 1 .. 256.
	static const uint16_t *table() {
		static const std::array<uint16_t, 257> COSTS = [] {
			std::array<uint16_t, 257> values{};
			for (size_t i = 1; i <= 256; ++i) {
				values[i] = uint16_t(std::lround(-256.0 * portable_log2(double(i) / 256.0)));
			}
			values[0] = values[1];
			return values;
		}();
		return COSTS.data();
	}

	uint32_t _cost = 0;
};

} // namespace net
