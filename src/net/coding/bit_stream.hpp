#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Appends bit fields to the caller's byte vector, least significant bit first. `flush()` pads the last byte with zero bits.
class BitWriter {
public:
	explicit BitWriter(std::vector<uint8_t> &bytes) :
			_bytes(bytes) {}

	/// Writes the low `count` bits of `value`; 0 <= count <= 56.
	void write(uint64_t value, int count) {
		_accumulator |= (value & ((uint64_t(1) << count) - 1)) << _filled;
		_filled += count;
		while (_filled >= 8) {
			_bytes.push_back(uint8_t(_accumulator));
			_accumulator >>= 8;
			_filled -= 8;
		}
	}

	/// LEB128: groups of 7 bits, low bits first; the high bit of each byte is 1 if another group follows.
	void write_varint(uint64_t value) {
		while (value >= 0x80) {
			write((value & 0x7f) | 0x80, 8);
			value >>= 7;
		}
		write(value, 8);
	}

	void flush() {
		if (_filled > 0) {
			write(0, 8 - _filled);
		}
	}

private:
	std::vector<uint8_t> &_bytes;
	uint64_t _accumulator = 0;
	int _filled = 0;
};

/// Reads the output of BitWriter. Past the end, reads return 0 and `failed()` stays true, so a decoder can check once after a
/// group of fields.
class BitReader {
public:
	BitReader(const uint8_t *bytes, size_t size) :
			_bytes(bytes), _size(size) {}

	/// Reads `count` bits; 0 <= count <= 56.
	uint64_t read(int count) {
		while (_filled < count) {
			if (_next == _size) {
				_failed = true;
				return 0;
			}
			_accumulator |= uint64_t(_bytes[_next++]) << _filled;
			_filled += 8;
		}
		const uint64_t value = _accumulator & ((uint64_t(1) << count) - 1);
		_accumulator >>= count;
		_filled -= count;
		return value;
	}

	/// Reads at most 9 groups (63 bits). A longer varint fails.
	uint64_t read_varint() {
		uint64_t value = 0;
		for (int shift = 0; shift < 63; shift += 7) {
			const uint64_t group = read(8);
			value |= (group & 0x7f) << shift;
			if (group < 0x80) {
				return value;
			}
		}
		_failed = true;
		return 0;
	}

	[[nodiscard]] bool failed() const { return _failed; }
	[[nodiscard]] size_t bits_left() const { return (_size - _next) * 8 + size_t(_filled); }
	/// True if only the padding of `flush()` is left: fewer than 8 bits, all zero.
	[[nodiscard]] bool at_end() const { return _next == _size && _filled < 8 && _accumulator == 0; }

private:
	const uint8_t *_bytes;
	size_t _size;
	size_t _next = 0;
	uint64_t _accumulator = 0;
	int _filled = 0;
	bool _failed = false;
};

/// Maps signed to unsigned integers, small magnitudes first: 0, -1, 1, -2, ... to 0, 1, 2, 3, ...
[[nodiscard]] constexpr uint64_t zigzag(int64_t value) {
	return (uint64_t(value) << 1) ^ (value < 0 ? ~uint64_t(0) : 0);
}

[[nodiscard]] constexpr int64_t unzigzag(uint64_t code) {
	return int64_t(code >> 1) ^ -int64_t(code & 1);
}

/// Number of bits needed to represent any value from 0 to `max`.
[[nodiscard]] constexpr int bit_width(uint64_t max) {
	int bits = 0;
	while (max != 0) {
		++bits;
		max >>= 1;
	}
	return bits;
}

} // namespace net
