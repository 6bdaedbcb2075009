#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Appends bit fields to a byte vector, least significant bit first.
///
/// The vector is the caller's, so a sender that keeps it allocates nothing in
/// steady state. `flush()` pads the last byte with zero bits.
class BitWriter {
public:
	explicit BitWriter(std::vector<std::uint8_t> &bytes) :
			bytes_(bytes) {}

	/// Writes the low `count` bits of `value`; 0 <= count <= 56.
	void write(std::uint64_t value, int count) {
		accumulator_ |= (value & ((std::uint64_t(1) << count) - 1)) << filled_;
		filled_ += count;
		while (filled_ >= 8) {
			bytes_.push_back(std::uint8_t(accumulator_));
			accumulator_ >>= 8;
			filled_ -= 8;
		}
	}

	/// LEB128 in 8-bit groups: 7 bits of value, then 1 if more follow.
	void write_varint(std::uint64_t value) {
		while (value >= 0x80) {
			write((value & 0x7f) | 0x80, 8);
			value >>= 7;
		}
		write(value, 8);
	}

	void flush() {
		if (filled_ > 0) {
			write(0, 8 - filled_);
		}
	}

private:
	std::vector<std::uint8_t> &bytes_;
	std::uint64_t accumulator_ = 0;
	int filled_ = 0;
};

/// Reads what BitWriter wrote. Past the end it returns zeros and stays failed,
/// so a decoder checks once, after a group of fields.
class BitReader {
public:
	BitReader(const std::uint8_t *bytes, std::size_t size) :
			bytes_(bytes), size_(size) {}

	/// Reads `count` bits; 0 <= count <= 56.
	std::uint64_t read(int count) {
		while (filled_ < count) {
			if (next_ == size_) {
				failed_ = true;
				return 0;
			}
			accumulator_ |= std::uint64_t(bytes_[next_++]) << filled_;
			filled_ += 8;
		}
		const std::uint64_t value = accumulator_ & ((std::uint64_t(1) << count) - 1);
		accumulator_ >>= count;
		filled_ -= count;
		return value;
	}

	/// At most 9 groups (63 bits); a longer one fails.
	std::uint64_t read_varint() {
		std::uint64_t value = 0;
		for (int shift = 0; shift < 63; shift += 7) {
			const std::uint64_t group = read(8);
			value |= (group & 0x7f) << shift;
			if (group < 0x80) {
				return value;
			}
		}
		failed_ = true;
		return 0;
	}

	[[nodiscard]] bool failed() const { return failed_; }
	[[nodiscard]] std::size_t bits_left() const { return (size_ - next_) * 8 + std::size_t(filled_); }
	/// True if only the padding of `flush()` is left: fewer than 8 bits, all zero.
	[[nodiscard]] bool at_end() const { return next_ == size_ && filled_ < 8 && accumulator_ == 0; }

private:
	const std::uint8_t *bytes_;
	std::size_t size_;
	std::size_t next_ = 0;
	std::uint64_t accumulator_ = 0;
	int filled_ = 0;
	bool failed_ = false;
};

/// Signed to unsigned with small magnitudes first: 0, -1, 1, -2, ... to 0, 1, 2, 3, ...
[[nodiscard]] constexpr std::uint64_t zigzag(std::int64_t value) {
	return (std::uint64_t(value) << 1) ^ (value < 0 ? ~std::uint64_t(0) : 0);
}

[[nodiscard]] constexpr std::int64_t unzigzag(std::uint64_t code) {
	return std::int64_t(code >> 1) ^ -std::int64_t(code & 1);
}

/// Bits that hold any value from 0 to `largest`.
[[nodiscard]] constexpr int bit_width(std::uint64_t largest) {
	int bits = 0;
	while (largest != 0) {
		++bits;
		largest >>= 1;
	}
	return bits;
}

} // namespace net
