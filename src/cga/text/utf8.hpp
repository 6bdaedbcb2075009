#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// Characters of texts in UTF-8, of which nothing is trusted.

namespace cga {

struct Character {
	uint32_t code = 0;
	size_t length = 1; // bytes
	bool is_valid = true; // if not: one byte that begins no character
};

// The character at a byte offset inside of the text.
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
	// No second way to write a character, no half of a UTF-16 pair, none beyond the last.
	constexpr uint32_t SMALLEST[] = { 0, 0, 0x80, 0x800, 0x10000 };
	const bool is_valid = code >= SMALLEST[length] && !(code >= 0xd800 && code <= 0xdfff) && code <= 0x10ffff;
	return is_valid ? Character{ code, length, true } : invalid;
}

// Bytes that are no UTF-8 count as a character each.
[[nodiscard]] constexpr int character_count(std::string_view text) {
	int count = 0;
	for (size_t offset = 0; offset < text.size(); offset += character_at(text, offset).length) {
		++count;
	}
	return count;
}

} // namespace cga
