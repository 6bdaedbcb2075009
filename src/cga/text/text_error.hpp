#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

// What is wrong with a text that was read, and where.

namespace cga {

struct TextError {
	std::string message; // what was found and what was expected: "expected ')' or ','"
	size_t offset = 0; // in bytes from the start of the text
	int line = 1; // from 1
	int column = 1; // from 1, in characters (not bytes) of the line

	// "column 7: expected ')' or ','"; with "line 2, " before it where the text has more lines than one before it.
	[[nodiscard]] std::string describe() const;
};

// The error at a byte offset of a text in UTF-8; an offset beyond the end is the end.
[[nodiscard]] TextError text_error(std::string_view text, size_t offset, std::string message);

// What stands at a byte offset, for messages: "'x'", "the end", "the byte 0xff". Always printable, always UTF-8.
[[nodiscard]] std::string describe_character(std::string_view text, size_t offset);

// A value read from text, or why there is none.
template <class T>
class TextResult {
public:
	TextResult(T value) :
			_value(std::move(value)) {}
	TextResult(TextError error) :
			_error(std::move(error)) {}

	[[nodiscard]] bool has_value() const { return _value.has_value(); }
	[[nodiscard]] explicit operator bool() const { return has_value(); }
	// Only where there is a value.
	[[nodiscard]] const T &operator*() const { return *_value; }
	[[nodiscard]] const T *operator->() const { return &*_value; }
	// Only where there is none.
	[[nodiscard]] const TextError &error() const { return _error; }

private:
	std::optional<T> _value;
	TextError _error;
};

} // namespace cga
