#include "cga/text/text_error.hpp"

#include "cga/text/utf8.hpp"

#include <algorithm>

namespace cga {

std::string TextError::describe() const {
	const std::string in_line = "column " + std::to_string(column) + ": " + message;
	return line > 1 ? "line " + std::to_string(line) + ", " + in_line : in_line;
}

TextError text_error(std::string_view text, size_t offset, std::string message) {
	const std::string_view before = text.substr(0, std::min(offset, text.size()));
	const size_t line_start = before.rfind('\n') + 1; // npos + 1 = 0 on the first line
	const int line = 1 + int(std::count(before.begin(), before.end(), '\n'));
	return { std::move(message), before.size(), line, 1 + character_count(before.substr(line_start)) };
}

std::string describe_character(std::string_view text, size_t offset) {
	if (offset >= text.size()) {
		return "the end";
	}
	const Character character = character_at(text, offset);
	if (character.code >= 0x20 && character.code != 0x7f && character.is_valid) {
		return "'" + std::string(text.substr(offset, character.length)) + "'";
	}
	constexpr char DIGITS[] = "0123456789abcdef";
	const unsigned byte = uint8_t(text[offset]);
	return std::string(character.is_valid ? "the control character 0x" : "the byte 0x") + DIGITS[byte >> 4] + DIGITS[byte & 15];
}

} // namespace cga
