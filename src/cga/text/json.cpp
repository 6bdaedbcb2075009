#include "cga/text/json.hpp"

#include "cga/text/number_text.hpp"

#include <bitset>
#include <charconv>

namespace cga {

namespace {

constexpr size_t MAX_JSON_LENGTH = 65536;
constexpr std::string_view COEFFICIENTS = "coefficients";

constexpr bool is_digit(char character) {
	return character >= '0' && character <= '9';
}

// Reads from the start to the end of the text; the first thing that is wrong is kept and stops all further reading.
class Reader {
public:
	explicit Reader(std::string_view text) :
			_text(text) {}

	TextResult<Multivector> read() {
		if (_text.size() > MAX_JSON_LENGTH) {
			return text_error(_text, MAX_JSON_LENGTH, "expected the end of the text, which may have 65,536 bytes; this one has " + std::to_string(_text.size()));
		}
		if (next_is('{')) {
			read_object();
		} else if (next_is('[')) {
			read_array();
		} else {
			fail_expected("'[' or '{'");
		}
		next_character();
		if (!_error && _position < _text.size()) {
			fail_expected("the end");
		}
		return _error ? TextResult<Multivector>(*_error) : TextResult<Multivector>(_value);
	}

private:
	// The next character that is no white space; 0 at the end.
	char next_character() {
		while (_position < _text.size() && std::string_view(" \t\r\n").find(_text[_position]) != std::string_view::npos) {
			++_position;
		}
		return _position < _text.size() ? _text[_position] : '\0';
	}

	bool next_is(char character) { return next_character() == character; }

	bool fail(size_t offset, std::string message) {
		if (!_error) {
			_error = text_error(_text, offset, std::move(message));
		}
		return false;
	}

	bool fail_expected(const std::string &what) {
		return fail(_position, "expected " + what + ", found " + describe_character(_text, _position));
	}

	bool take(char character, const std::string &what) {
		if (!next_is(character)) {
			return fail_expected(what);
		}
		++_position;
		return true;
	}

	size_t take_digits() {
		const size_t start = _position;
		while (_position < _text.size() && is_digit(_text[_position])) {
			++_position;
		}
		return _position - start;
	}

	bool take_one_of(std::string_view characters) {
		if (_position >= _text.size() || characters.find(_text[_position]) == std::string_view::npos) {
			return false;
		}
		++_position;
		return true;
	}

	// -? (0 | [1-9][0-9]*) (. [0-9]+)? ([eE] [+-]? [0-9]+)?
	bool read_number_into(double &value) {
		const char first = next_character();
		const size_t start = _position;
		if (first != '-' && !is_digit(first)) {
			return fail_expected("a number");
		}
		take_one_of("-");
		if (!take_one_of("0") && take_digits() == 0) {
			return fail_expected("a digit");
		}
		if (take_one_of(".") && take_digits() == 0) {
			return fail_expected("a digit after the decimal point");
		}
		if (take_one_of("eE")) {
			take_one_of("+-");
			if (take_digits() == 0) {
				return fail_expected("a digit of the exponent");
			}
		}
		const std::optional<double> read = read_number(_text.substr(start, _position - start));
		if (!read) {
			return fail(start, "expected a number that a double can hold (up to 1.8e308); this one is too large");
		}
		value = *read;
		return true;
	}

	bool read_array() {
		take('[', "'['");
		for (int index = 0; index < BLADE_COUNT; ++index) {
			if (next_is(']')) {
				return fail(_position, "expected 32 numbers, found the end of the array after " + std::to_string(index));
			}
			if ((index > 0 && !take(',', "',' or ']'")) || !read_number_into(_value[index])) {
				return false;
			}
		}
		return take(']', "']' after 32 numbers");
	}

	// A key and the colon after it. No escapes: no key that is read here has any.
	bool read_key(std::string_view &key, size_t &offset) {
		if (!take('"', "a key in double quotes")) {
			return false;
		}
		offset = _position - 1;
		const size_t end = _text.find_first_of("\"\\", _position);
		if (end == std::string_view::npos || _text[end] == '\\') {
			return fail(offset, "expected the key \"coefficients\" or \"0\" to \"31\"");
		}
		key = _text.substr(_position, end - _position);
		_position = end + 1;
		return take(':', "':' after the key");
	}

	bool read_object() {
		take('{', "'{'");
		std::bitset<BLADE_COUNT> seen;
		while (!seen.all()) {
			std::string_view key;
			size_t offset = 0;
			if (seen.any() && next_is('}')) {
				return fail(_position, "expected 32 numbers, found the end of the object after " + std::to_string(seen.count()));
			}
			if ((seen.any() && !take(',', "',' or '}'")) || !read_key(key, offset)) {
				return false;
			}
			if (key == COEFFICIENTS && seen.none()) {
				return read_array() && take('}', "'}' after the coefficients");
			}
			const std::optional<int> index = index_of_key(key);
			if (!index) {
				return fail(offset, seen.any() ? "expected a key \"0\" to \"31\"" : "expected the key \"coefficients\" or \"0\" to \"31\"");
			}
			if (seen[size_t(*index)]) {
				return fail(offset, "expected each key once; \"" + std::to_string(*index) + "\" stood before");
			}
			seen.set(size_t(*index));
			if (!read_number_into(_value[*index])) {
				return false;
			}
		}
		return take('}', "'}' after 32 numbers");
	}

	// "0" .. "31", without leading zeros.
	static std::optional<int> index_of_key(std::string_view key) {
		int index = -1;
		const char *end = key.data() + key.size();
		const bool is_number = std::from_chars(key.data(), end, index).ptr == end;
		if (!is_number || index < 0 || index >= BLADE_COUNT || key != std::to_string(index)) {
			return std::nullopt;
		}
		return index;
	}

	std::string_view _text;
	size_t _position = 0;
	Multivector _value;
	std::optional<TextError> _error;
};

} // namespace

std::string to_json(const Multivector &x) {
	std::string text = "[";
	for (int index = 0; index < BLADE_COUNT; ++index) {
		text += index > 0 ? "," : "";
		append_number(text, x[index]);
	}
	return text + "]";
}

TextResult<Multivector> from_json(std::string_view text) {
	return Reader(text).read();
}

} // namespace cga
