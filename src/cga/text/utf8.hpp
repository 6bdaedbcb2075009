#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// Decodes UTF-8 that may be invalid.

namespace cga {

[[nodiscard]] constexpr bool is_digit(uint32_t code) {
	return code >= '0' && code <= '9';
}

struct Character {
	uint32_t code = 0;
	size_t length = 1; // bytes
	bool is_valid = true; // false for a single byte that does not start a valid character
};

// The character at a byte offset. Precondition: offset < text.size().
[[nodiscard]] constexpr Character character_at(std::string_view text, size_t offset) {
	const unsigned lead = uint8_t(text[offset]);
	if (lead < 0x80) {
		return { lead, 1, true };
	}
	const size_t length = lead >= 0xf0 ? 4 : (lead >= 0xe0 ? 3 : 2);
	const Character invalid{ lead, 1, false };
	if (lead < 0xc2 || lead > 0xf4 || length > text.size() - offset) {
		return invalid;
	}
	uint32_t code = lead & (0x7fu >> length);
	for (size_t next = 1; next < length; ++next) {
		const unsigned byte = uint8_t(text[offset + next]);
		if ((byte & 0xc0) != 0x80) {
			return invalid;
		}
		code = code << 6 | (byte & 0x3f);
	}
	// Rejects overlong encodings, surrogates and codes beyond U+10FFFF.
	constexpr uint32_t MIN_CODES[] = { 0, 0, 0x80, 0x800, 0x10000 };
	const bool is_valid = code >= MIN_CODES[length] && !(code >= 0xd800 && code <= 0xdfff) && code <= 0x10ffff;
	return is_valid ? Character{ code, length, true } : invalid;
}

// Each invalid byte counts as one character.
[[nodiscard]] constexpr int character_count(std::string_view text) {
	int count = 0;
	for (size_t offset = 0; offset < text.size(); offset += character_at(text, offset).length) {
		++count;
	}
	return count;
}

} // namespace cga
