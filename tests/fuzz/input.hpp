#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

// Common code of the fuzz targets. A target defines fuzz::run(); tests/fuzz/README.md describes how to build and run them.

namespace fuzz {

using Bytes = std::vector<uint8_t>;

/// Ends the process, which reports the input as a finding, if the condition is false.
inline void require(bool condition, const char *failure) {
	if (!condition) {
		std::fprintf(stderr, "fuzz target: %s\n", failure);
		std::abort();
	}
}

/// As above, with a text that shows what failed.
inline void require(bool condition, const char *failure, const std::string &text) {
	if (!condition) {
		std::fprintf(stderr, "fuzz target: %s\n%s\n", failure, text.c_str());
		std::abort();
	}
}

/// Decodes the bytes of a fuzzer to decisions. At the end of the bytes all of them are 0.
class Input {
public:
	Input(const uint8_t *bytes, size_t size) :
			_bytes(bytes), _left(size) {}

	[[nodiscard]] bool is_empty() const { return _left == 0; }

	uint8_t byte() {
		if (_left == 0) {
			return 0;
		}
		--_left;
		return *_bytes++;
	}
	bool flag() { return (byte() & 1) != 0; }
	/// `count` bytes, little-endian.
	uint64_t bits(int count) {
		uint64_t value = 0;
		for (int i = 0; i < count; ++i) {
			value |= uint64_t(byte()) << (8 * i);
		}
		return value;
	}
	/// 0 to limit - 1. Takes one byte for limits up to 256.
	size_t below(size_t limit) { return size_t(bits(limit <= 256 ? 1 : (limit <= 65536 ? 2 : 4))) % limit; }
	/// From min to max.
	double between(double min, double max) { return min + (max - min) * double(bits(2)) / 65535.0; }

	/// Any double: a common, a special or a small one, one of any size, or any bits.
	double number() {
		static constexpr double SPECIAL[] = { 0.0, -0.0, 1.0, -1.0, 0.5, 1e-300, 1e300, 5e-324, 1.7976931348623157e308, -1e9, 1e21, 1e-9 };
		const uint8_t kind = byte();
		if (kind < 128) {
			return double(int8_t(uint8_t(kind << 1))) / 16.0;
		}
		if (kind < 192) {
			return between(-100.0, 100.0);
		}
		if (kind < 224) {
			return SPECIAL[kind % std::size(SPECIAL)];
		}
		const uint64_t code = bits(8);
		double value = 0.0;
		std::memcpy(&value, &code, sizeof(value));
		return value;
	}
	/// number(), or 0 if it is not finite.
	double finite_number() {
		const double value = number();
		return value - value == 0.0 ? value : 0.0;
	}

	/// The next bytes, at most `count`.
	Bytes take(size_t count) {
		const size_t size = std::min(count, _left);
		Bytes taken(_bytes, _bytes + size);
		_bytes += size;
		_left -= size;
		return taken;
	}
	/// A length in one byte, then as many bytes.
	std::string text() {
		const Bytes taken = take(byte());
		return std::string(taken.begin(), taken.end());
	}
	Bytes rest() { return take(_left); }
	std::string rest_text() {
		const Bytes taken = rest();
		return std::string(taken.begin(), taken.end());
	}

private:
	const uint8_t *_bytes;
	size_t _left;
};

/// Edits a packet as the input says: flips a bit, replaces, removes or inserts bytes, truncates.
inline void edit(Bytes &bytes, Input &input) {
	const size_t at = bytes.empty() ? 0 : input.below(bytes.size());
	const auto position = bytes.begin() + ptrdiff_t(at);
	switch (input.byte() % 5) {
		case 0:
			if (!bytes.empty()) {
				bytes[at] ^= uint8_t(1u << (input.byte() % 8));
			}
			break;
		case 1: {
			const Bytes replacement = input.take(std::min<size_t>(bytes.size() - at, 1 + input.byte() % 4));
			std::copy(replacement.begin(), replacement.end(), position);
			break;
		}
		case 2:
			bytes.resize(at);
			break;
		case 3: {
			const Bytes inserted = input.take(1 + input.byte() % 16);
			bytes.insert(position, inserted.begin(), inserted.end());
			break;
		}
		default:
			bytes.erase(position, position + ptrdiff_t(std::min<size_t>(bytes.size() - at, 1 + input.byte() % 8)));
	}
}

/// Interprets an input. Called with any bytes; a violated requirement, a sanitizer's report and a timeout are findings.
void run(Input input);

} // namespace fuzz
