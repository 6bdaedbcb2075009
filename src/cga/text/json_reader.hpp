#pragma once

#include "cga/text/text_error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// Reads JSON piece by piece, as whoever knows what should stand there asks for it.

namespace cga {

// The first thing that is wrong is kept with its place, and every reading after it fails. Texts need not be UTF-8;
// strings that are read from them are.
class JsonReader {
public:
	explicit JsonReader(std::string_view text) :
			_text(text) {}

	[[nodiscard]] size_t position() const { return _position; }
	[[nodiscard]] const std::optional<TextError> &error() const { return _error; }
	// Goes on reading elsewhere; what was wrong is forgotten.
	void restart_at(size_t position);

	// The next character that is no white space, which stays; 0 at the end.
	char next_character();
	[[nodiscard]] bool next_is(char character) { return next_character() == character; }
	[[nodiscard]] bool is_at_end();

	// Takes the character, or fails with "expected <what>, found ...".
	bool take(char character, const std::string &what);
	// A number by JSON's grammar: no nan, no hexadecimal, no leading plus. One too large for a double is an error.
	bool read_number(double &value);
	// With all escapes; an error for control characters, for what is no UTF-8 and for halves of UTF-16 pairs.
	bool read_string(std::string &value);
	bool read_boolean(bool &value);
	bool read_null();
	// Any value, passed over; brackets up to MAX_NESTING deep.
	bool skip_value();

	bool fail(size_t offset, std::string message);
	// "expected <what>, found ...", here.
	bool fail_expected(const std::string &what);

private:
	size_t take_digits();
	bool take_one_of(std::string_view characters);
	bool take_word(std::string_view word);
	bool read_escape(std::string &value);
	bool read_hexadecimal(uint32_t &code);

	std::string_view _text;
	size_t _position = 0;
	std::optional<TextError> _error;
};

// `text` between double quotes, with what JSON wants to be escaped; bytes that are no UTF-8 become U+FFFD.
void append_json_string(std::string &json, std::string_view text);

} // namespace cga
