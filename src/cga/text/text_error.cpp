#include "cga/text/text_error.hpp"

#include "cga/text/utf8.hpp"

#include <algorithm>
#include <numeric>

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

std::vector<std::string> describe_errors(std::string_view text, const std::vector<OffsetError> &errors) {
	std::vector<size_t> order(errors.size());
	std::iota(order.begin(), order.end(), size_t(0));
	std::sort(order.begin(), order.end(), [&errors](size_t left, size_t right) { return errors[left].offset < errors[right].offset; });
	std::vector<std::string> descriptions(errors.size());
	TextError place;
	for (const size_t index : order) {
		const size_t offset = std::min(errors[index].offset, text.size());
		const std::string_view between = text.substr(place.offset, offset - place.offset);
		const size_t line_end = between.rfind('\n');
		place.line += int(std::count(between.begin(), between.end(), '\n'));
		place.column = line_end == std::string_view::npos ? place.column + character_count(between) : 1 + character_count(between.substr(line_end + 1));
		place.offset = offset;
		place.message = errors[index].message;
		descriptions[index] = place.describe();
	}
	return descriptions;
}

std::string shortened(std::string_view text) {
	if (text.size() <= MAX_QUOTED_LENGTH) {
		return std::string(text);
	}
	size_t length = MAX_QUOTED_LENGTH;
	while (length > 0 && (uint8_t(text[length]) & 0xc0) == 0x80) {
		--length; // not within a character
	}
	return std::string(text.substr(0, length)) + "...";
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
