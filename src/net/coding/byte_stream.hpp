#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace net {

/// Appends an integer or a floating-point number, little-endian: its first `size` bytes.
template <class Number>
void put_number(std::vector<uint8_t> &bytes, Number number, size_t size = sizeof(Number)) {
	uint64_t bits = 0;
	std::memcpy(&bits, &number, sizeof(number));
	for (size_t i = 0; i < size; ++i) {
		bytes.push_back(uint8_t(bits >> (8 * i)));
	}
}

/// Reads little-endian numbers. Past the end, reads return 0 and `failed()` stays true.
class ByteReader {
public:
	ByteReader(const uint8_t *bytes, size_t size) :
			_bytes(bytes), _left(size) {}

	/// Reads an integer or a floating-point number from its first `size` bytes; the others are 0.
	template <class Number>
	Number read(size_t size = sizeof(Number)) {
		uint64_t bits = 0;
		const uint8_t *from = take(size);
		for (size_t i = 0; from != nullptr && i < size; ++i) {
			bits |= uint64_t(from[i]) << (8 * i);
		}
		Number number;
		std::memcpy(&number, &bits, sizeof(number));
		return number;
	}

	/// Skips `count` bytes and returns a pointer to them; null if fewer are left.
	const uint8_t *take(size_t count) {
		_failed = _failed || count > _left;
		const size_t taken = _failed ? _left : count;
		_bytes += taken;
		_left -= taken;
		return _failed ? nullptr : _bytes - taken;
	}

	[[nodiscard]] size_t left() const { return _left; }
	[[nodiscard]] bool failed() const { return _failed; }

private:
	const uint8_t *_bytes;
	size_t _left;
	bool _failed = false;
};

} // namespace net
