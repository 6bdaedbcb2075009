#pragma once

#include "cga/text/text_error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// A pull parser for JSON: the caller asks for the value it expects next.

namespace cga {

// The reader keeps the first error, and every call after it fails. The text may contain invalid UTF-8; returned strings
// never do.
class JsonReader {
public:
	explicit JsonReader(std::string_view text) :
			_text(text) {}

	// In bytes from the start of the text.
	[[nodiscard]] size_t position() const { return _position; }
	[[nodiscard]] const std::optional<OffsetError> &error() const { return _error; }
	// Clears the error and continues at `position`.
	void restart_at(size_t position);

	// Skips white space and returns the next character without consuming it; 0 at the end.
	char next_character();
	[[nodiscard]] bool next_is(char character) { return next_character() == character; }
	[[nodiscard]] bool is_at_end();

	// Consumes the character, or fails with "expected <what>, found ...".
	bool take(char character, const std::string &what);
	// The functions below return nothing, or false, after an error.
	// A number by JSON's grammar: no NaN, no hexadecimal, no leading plus. One too large for a double is an error.
	std::optional<double> read_number();
	// Resolves all escapes. Control characters, invalid UTF-8 and unpaired surrogates are errors.
	std::optional<std::string> read_string();
	std::optional<bool> read_boolean();
	bool read_null();
	// Skips a value of any type. Nesting deeper than MAX_NESTING is an error.
	bool skip_value();

	// Both return false. An earlier error stays.
	bool fail(size_t offset, std::string message);
	// "expected <what>, found ...", at the current position.
	bool fail_expected(const std::string &what);

private:
	size_t take_digits();
	bool take_one_of(std::string_view characters);
	bool take_word(std::string_view word);
	std::optional<uint32_t> read_escape();
	std::optional<uint32_t> read_hexadecimal();

	std::string_view _text;
	size_t _position = 0;
	std::optional<OffsetError> _error;
};

// Appends `text` as a JSON string: quoted and escaped. Each invalid byte of UTF-8 becomes U+FFFD.
void append_json_string(std::string &json, std::string_view text);

} // namespace cga
