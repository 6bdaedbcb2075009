#include "cga/text/json_reader.hpp"

#include "cga/text/number_text.hpp"
#include "cga/text/utf8.hpp"

#include <charconv>

namespace cga {

namespace {

constexpr size_t MAX_NESTING = 256;
constexpr std::string_view REPLACEMENT_CHARACTER = "\xef\xbf\xbd";

void append_utf8(std::string &text, uint32_t code) {
	if (code < 0x80) {
		text += char(code);
		return;
	}
	const int following = code >= 0x10000 ? 3 : (code >= 0x800 ? 2 : 1);
	constexpr unsigned LEADS[] = { 0, 0xc0, 0xe0, 0xf0 };
	text += char(LEADS[following] | code >> (6 * following));
	for (int byte = following - 1; byte >= 0; --byte) {
		text += char(0x80 | (code >> (6 * byte) & 0x3f));
	}
}

} // namespace

void JsonReader::restart_at(size_t position) {
	_position = position;
	_error.reset();
}

char JsonReader::next_character() {
	while (_position < _text.size() && std::string_view(" \t\r\n").find(_text[_position]) != std::string_view::npos) {
		++_position;
	}
	return _position < _text.size() ? _text[_position] : '\0';
}

bool JsonReader::is_at_end() {
	next_character();
	return _position >= _text.size();
}

bool JsonReader::fail(size_t offset, std::string message) {
	if (!_error) {
		_error = OffsetError{ std::move(message), offset };
	}
	return false;
}

bool JsonReader::fail_expected(const std::string &what) {
	return fail(_position, "expected " + what + ", found " + describe_character(_text, _position));
}

bool JsonReader::take(char character, const std::string &what) {
	if (_error || !next_is(character)) {
		return fail_expected(what);
	}
	++_position;
	return true;
}

size_t JsonReader::take_digits() {
	const size_t start = _position;
	while (_position < _text.size() && is_digit(_text[_position])) {
		++_position;
	}
	return _position - start;
}

bool JsonReader::take_one_of(std::string_view characters) {
	if (_position >= _text.size() || characters.find(_text[_position]) == std::string_view::npos) {
		return false;
	}
	++_position;
	return true;
}

// -? (0 | [1-9][0-9]*) (. [0-9]+)? ([eE] [+-]? [0-9]+)?
std::optional<double> JsonReader::read_number() {
	const auto expected = [this](const char *what) {
		fail_expected(what);
		return std::nullopt;
	};
	const char first = next_character();
	const size_t start = _position;
	if (_error || (first != '-' && !is_digit(first))) {
		return expected("a number");
	}
	take_one_of("-");
	if (!take_one_of("0") && take_digits() == 0) {
		return expected("a digit");
	}
	if (take_one_of(".") && take_digits() == 0) {
		return expected("a digit after the decimal point");
	}
	if (take_one_of("eE")) {
		take_one_of("+-");
		if (take_digits() == 0) {
			return expected("a digit of the exponent");
		}
	}
	const std::optional<double> value = cga::read_number(_text.substr(start, _position - start));
	if (!value) {
		fail(start, "the number is too large; at most 1.8e308 is accepted");
	}
	return value;
}

std::optional<std::string> JsonReader::read_string() {
	if (!take('"', "a string in double quotes")) {
		return std::nullopt;
	}
	std::string value;
	while (_position < _text.size() && _text[_position] != '"') {
		if (_text[_position] == '\\') {
			const std::optional<uint32_t> code = read_escape();
			if (!code) {
				return std::nullopt;
			}
			append_utf8(value, *code);
			continue;
		}
		const Character character = character_at(_text, _position);
		if (!character.is_valid || character.code < 0x20) {
			fail_expected("a character or '\"'");
			return std::nullopt;
		}
		value.append(_text, _position, character.length);
		_position += character.length;
	}
	return take('"', "'\"' at the end of the string") ? std::optional<std::string>(std::move(value)) : std::nullopt;
}

// At a backslash. Returns the code point.
std::optional<uint32_t> JsonReader::read_escape() {
	constexpr std::string_view LETTERS = "\"\\/bfnrt";
	constexpr std::string_view MEANINGS = "\"\\/\b\f\n\r\t";
	const size_t start = _position++;
	const char letter = _position < _text.size() ? _text[_position] : '\0';
	if (const size_t index = LETTERS.find(letter); letter != '\0' && index != std::string_view::npos) {
		++_position;
		return uint32_t(MEANINGS[index]);
	}
	_position += letter == 'u' ? 1 : 0;
	const std::optional<uint32_t> code = letter == 'u' ? read_hexadecimal() : std::nullopt;
	if (!code) {
		fail(start, "expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\u and four hexadecimal digits");
		return std::nullopt;
	}
	if (*code < 0xd800 || *code >= 0xe000) {
		return code;
	}
	if (*code < 0xdc00 && _text.substr(_position, 2) == "\\u") {
		_position += 2;
		if (const std::optional<uint32_t> low = read_hexadecimal(); low && *low >= 0xdc00 && *low < 0xe000) {
			return 0x10000 + ((*code - 0xd800) << 10) + (*low - 0xdc00);
		}
	}
	fail(start, "expected a character, found an unpaired UTF-16 surrogate");
	return std::nullopt;
}

std::optional<uint32_t> JsonReader::read_hexadecimal() {
	const std::string_view digits = _text.substr(_position, 4);
	uint32_t code = 0;
	const char *end = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16).ptr;
	if (digits.size() < 4 || end != digits.data() + digits.size()) {
		return std::nullopt;
	}
	_position += 4;
	return code;
}

bool JsonReader::take_word(std::string_view word) {
	next_character();
	if (_error || _text.substr(_position, word.size()) != word) {
		return false;
	}
	_position += word.size();
	return true;
}

std::optional<bool> JsonReader::read_boolean() {
	if (take_word("true")) {
		return true;
	}
	return take_word("false") || fail_expected("true or false") ? std::optional<bool>(false) : std::nullopt;
}

bool JsonReader::read_null() {
	return take_word("null") || fail_expected("null");
}

bool JsonReader::skip_value() {
	std::string open; // unclosed brackets
	do {
		const char first = next_character();
		if (first == '[' || first == '{') {
			if (open.size() >= MAX_NESTING) {
				return fail(_position, "the value is nested too deeply; at most " + std::to_string(MAX_NESTING) + " levels are accepted");
			}
			open += first;
			++_position;
		} else if (first == '"' ? !read_string() : (first == 't' || first == 'f' ? !read_boolean() : (first == 'n' ? !read_null() : !read_number()))) {
			return false;
		}
		// Between two values: closing brackets, a comma, a key.
		bool is_first = first == '[' || first == '{';
		while (!open.empty() && next_is(open.back() == '[' ? ']' : '}')) {
			++_position;
			open.pop_back();
			is_first = false;
		}
		if (!open.empty() && !is_first && !take(',', open.back() == '[' ? "',' or ']'" : "',' or '}'")) {
			return false;
		}
		if (!open.empty() && open.back() == '{' && !(read_string() && take(':', "':' after the key"))) {
			return false;
		}
	} while (!open.empty());
	return !_error;
}

void append_json_string(std::string &json, std::string_view text) {
	constexpr std::string_view MEANINGS = "\"\\\b\f\n\r\t";
	constexpr std::string_view LETTERS = "\"\\bfnrt";
	json += '"';
	for (size_t offset = 0; offset < text.size();) {
		const Character character = character_at(text, offset);
		if (const size_t index = MEANINGS.find(text[offset]); index != std::string_view::npos) {
			json += '\\';
			json += LETTERS[index];
		} else if (character.code < 0x20) {
			constexpr char DIGITS[] = "0123456789abcdef";
			json += "\\u00";
			json += DIGITS[character.code >> 4];
			json += DIGITS[character.code & 15];
		} else if (!character.is_valid) {
			json += REPLACEMENT_CHARACTER;
		} else {
			json.append(text, offset, character.length);
		}
		offset += character.length;
	}
	json += '"';
}

} // namespace cga
