#pragma once

#include "cga/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Parse errors with their position.

namespace cga {

struct TextError {
	std::string message; // what was expected or is wrong: "expected ')' or ',', found 'x'"; no final period
	size_t offset = 0; // in bytes from the start of the text
	int line = 1; // from 1
	int column = 1; // from 1, in characters (not bytes) of the line

	// "column 7: expected ...", preceded by "line 2, " unless it is on the first line.
	[[nodiscard]] std::string describe() const;
};

// An error whose line and column are not known: finding them takes a pass over the text.
struct OffsetError {
	std::string message;
	size_t offset = 0; // in bytes
};

// The error at a byte offset of a text in UTF-8; an offset beyond the end counts as the end.
[[nodiscard]] TextError text_error(std::string_view text, size_t offset, std::string message);

// The descriptions of errors in any order, in one pass over the text.
[[nodiscard]] std::vector<std::string> describe_errors(std::string_view text, const std::vector<OffsetError> &errors);

// A name or another piece of a text, for messages: at most MAX_QUOTED_LENGTH bytes of it, followed by "..." if it is longer.
inline constexpr size_t MAX_QUOTED_LENGTH = 256;
[[nodiscard]] std::string shortened(std::string_view text);

// The character at a byte offset, for messages: "'x'", "the end", "the byte 0xff". The result is printable UTF-8.
[[nodiscard]] std::string describe_character(std::string_view text, size_t offset);

// A value read from text, or why there is none.
template <class T>
using TextResult = Result<T, TextError>;

} // namespace cga
