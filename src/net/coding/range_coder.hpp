#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// An adaptive binary range coder (Martin, "Range encoding", 1979; carry handling and 32-bit arithmetic as in LZMA).
// Integers only, so that sender and receiver agree on every machine.

namespace net {

/// The estimated probability that a bit is 0: the mean of a fast and a slow running average, in 1/65536.
class AdaptiveBit {
public:
	constexpr AdaptiveBit() = default;
	constexpr explicit AdaptiveBit(std::uint16_t zero) :
			fast_(zero), slow_(zero) {}

	/// In 1/4096, never 0 or 1.
	[[nodiscard]] std::uint32_t zero() const {
		const std::uint32_t mean = (std::uint32_t(fast_) + slow_) >> 5;
		return mean < 16 ? 16 : (mean > 4080 ? 4080 : mean);
	}

	void update(bool bit) {
		if (bit) {
			fast_ = std::uint16_t(fast_ - (fast_ >> FAST));
			slow_ = std::uint16_t(slow_ - (slow_ >> SLOW));
		} else {
			fast_ = std::uint16_t(fast_ + ((65535 - fast_) >> FAST));
			slow_ = std::uint16_t(slow_ + ((65535 - slow_) >> SLOW));
		}
	}

	/// Both averages as one number, and back.
	[[nodiscard]] std::uint32_t state() const { return std::uint32_t(fast_) << 16 | slow_; }
	void set_state(std::uint32_t state) {
		fast_ = std::uint16_t(state >> 16);
		slow_ = std::uint16_t(state);
	}

private:
	static constexpr int FAST = 4;
	static constexpr int SLOW = 7;
	std::uint16_t fast_ = 32768;
	std::uint16_t slow_ = 32768;
};

/// Appends coded bits to a byte vector of the caller's. `finish()` writes no byte that the reader's zeros stand for.
class RangeEncoder {
public:
	explicit RangeEncoder(std::vector<std::uint8_t> &bytes) :
			bytes_(bytes), begin_(bytes.size()) {}

	void bit(AdaptiveBit &model, bool &value) {
		const std::uint32_t bound = (range_ >> 12) * model.zero();
		if (value) {
			low_ += bound;
			range_ -= bound;
		} else {
			range_ = bound;
		}
		model.update(value);
		normalise();
	}

	/// The low `count` bits of `value`, all values equally likely; 0 <= count <= 32.
	void bits(std::uint32_t &value, int count) {
		for (int i = count - 1; i >= 0; --i) {
			range_ >>= 1;
			if (((value >> i) & 1) != 0) {
				low_ += range_;
			}
			normalise();
		}
	}

	void finish() {
		// Of the numbers that decode to what was coded, the one with the most zero bits at its end.
		for (int k = 32; k >= 0; --k) {
			const std::uint64_t mask = (std::uint64_t(1) << k) - 1;
			const std::uint64_t candidate = (low_ + mask) & ~mask;
			if (candidate < low_ + range_) {
				low_ = candidate;
				break;
			}
		}
		for (int i = 0; i < 5; ++i) {
			shift_low();
		}
		while (bytes_.size() > begin_ && bytes_.back() == 0) {
			bytes_.pop_back();
		}
	}

private:
	void normalise() {
		while (range_ < (1u << 24)) {
			range_ <<= 8;
			shift_low();
		}
	}

	void shift_low() {
		if (low_ < 0xff000000u || low_ >= (std::uint64_t(1) << 32)) {
			const std::uint8_t carry = std::uint8_t(low_ >> 32);
			if (!first_) {
				bytes_.push_back(std::uint8_t(cache_ + carry));
			}
			first_ = false;
			for (; pending_ > 0; --pending_) {
				bytes_.push_back(std::uint8_t(0xff + carry));
			}
			cache_ = std::uint8_t(low_ >> 24);
		} else {
			++pending_;
		}
		low_ = (low_ & 0x00ffffffu) << 8;
	}

	std::vector<std::uint8_t> &bytes_;
	std::size_t begin_;
	std::uint64_t low_ = 0;
	std::uint32_t range_ = 0xffffffffu;
	std::size_t pending_ = 0;
	std::uint8_t cache_ = 0;
	bool first_ = true; // the byte before the first is always 0 and not written
};

/// Reads what RangeEncoder wrote; past the end it reads zeros. Any bytes are safe input.
class RangeDecoder {
public:
	RangeDecoder(const std::uint8_t *bytes, std::size_t size) :
			bytes_(bytes), size_(size) {
		for (int i = 0; i < 4; ++i) {
			code_ = code_ << 8 | next();
		}
	}

	void bit(AdaptiveBit &model, bool &value) {
		const std::uint32_t bound = (range_ >> 12) * model.zero();
		value = code_ >= bound;
		if (value) {
			code_ -= bound;
			range_ -= bound;
		} else {
			range_ = bound;
		}
		model.update(value);
		normalise();
	}

	void bits(std::uint32_t &value, int count) {
		value = 0;
		for (int i = 0; i < count; ++i) {
			range_ >>= 1;
			const bool one = code_ >= range_;
			if (one) {
				code_ -= range_;
			}
			value = value << 1 | std::uint32_t(one);
			normalise();
		}
	}

	/// How many bytes beyond the end were read; more than 4 only for what RangeEncoder did not write.
	[[nodiscard]] std::size_t overrun() const { return overrun_; }

private:
	std::uint8_t next() {
		if (at_ < size_) {
			return bytes_[at_++];
		}
		++overrun_;
		return 0;
	}

	void normalise() {
		while (range_ < (1u << 24)) {
			range_ <<= 8;
			code_ = code_ << 8 | next();
		}
	}

	const std::uint8_t *bytes_;
	std::size_t size_;
	std::size_t at_ = 0;
	std::size_t overrun_ = 0;
	std::uint32_t range_ = 0xffffffffu;
	std::uint32_t code_ = 0;
};

/// Counts what coding would cost, in 1/256 bit, and leaves the models as they are.
class CostMeter {
public:
	void bit(const AdaptiveBit &model, bool value) {
		const std::uint32_t zero = model.zero();
		cost_ += table()[(value ? 4096 - zero : zero) >> 4];
	}
	void bits(std::uint32_t, int count) { cost_ += std::uint32_t(count) << 8; }
	[[nodiscard]] std::uint32_t cost() const { return cost_; }

private:
	/// -256 log2(p / 256) for p = 1 .. 256.
	static const std::uint16_t *table();
	std::uint32_t cost_ = 0;
};

} // namespace net
