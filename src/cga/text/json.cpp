#include "cga/text/json.hpp"

#include "cga/text/json_reader.hpp"
#include "cga/text/number_text.hpp"

#include <bitset>
#include <charconv>

namespace cga {

namespace {

constexpr size_t MAX_JSON_LENGTH = 65536;
constexpr std::string_view COEFFICIENTS = "coefficients";

class Reader {
public:
	explicit Reader(std::string_view text) :
			_text(text), _reader(text) {}

	TextResult<Multivector> read() {
		if (_text.size() > MAX_JSON_LENGTH) {
			return text_error(_text, MAX_JSON_LENGTH, "the text is too long: it has " + std::to_string(_text.size()) + " bytes, and at most " + std::to_string(MAX_JSON_LENGTH) + " are accepted");
		}
		if (_reader.next_is('{')) {
			read_object();
		} else if (_reader.next_is('[')) {
			read_array();
		} else {
			_reader.fail_expected("'[' or '{'");
		}
		if (!_reader.error() && !_reader.is_at_end()) {
			_reader.fail_expected("the end");
		}
		return _reader.error() ? TextResult<Multivector>(*_reader.error()) : TextResult<Multivector>(_value);
	}

private:
	bool read_array() {
		_reader.take('[', "'['");
		for (int index = 0; index < BLADE_COUNT; ++index) {
			if (_reader.next_is(']')) {
				return _reader.fail(_reader.position(), "expected 32 numbers, found the end of the array after " + std::to_string(index));
			}
			if (index > 0 && !_reader.take(',', "',' or ']'")) {
				return false;
			}
			const std::optional<double> number = _reader.read_number();
			if (!number) {
				return false;
			}
			_value[index] = *number;
		}
		return _reader.take(']', "']' after 32 numbers");
	}

	bool read_object() {
		_reader.take('{', "'{'");
		std::bitset<BLADE_COUNT> seen;
		while (!seen.all()) {
			if (seen.any() && _reader.next_is('}')) {
				return _reader.fail(_reader.position(), "expected 32 numbers, found the end of the object after " + std::to_string(seen.count()));
			}
			if (seen.any() && !_reader.take(',', "',' or '}'")) {
				return false;
			}
			if (!_reader.next_is('"')) {
				return _reader.fail_expected("a key in double quotes");
			}
			const size_t offset = _reader.position();
			const std::optional<std::string> key = _reader.read_string();
			if (!key || !_reader.take(':', "':' after the key")) {
				return false;
			}
			if (*key == COEFFICIENTS && seen.none()) {
				return read_array() && _reader.take('}', "'}' after the coefficients");
			}
			const std::optional<int> index = index_of_key(*key);
			if (!index) {
				return _reader.fail(offset, seen.any() ? "expected a key from \"0\" to \"31\"" : "expected the key \"coefficients\" or keys from \"0\" to \"31\"");
			}
			if (seen[size_t(*index)]) {
				return _reader.fail(offset, "the key \"" + std::to_string(*index) + "\" occurs twice");
			}
			const std::optional<double> number = _reader.read_number();
			if (!number) {
				return false;
			}
			seen.set(size_t(*index));
			_value[*index] = *number;
		}
		return _reader.take('}', "'}' after 32 numbers");
	}

	// "0" .. "31" without leading zeros; empty for anything else.
	static std::optional<int> index_of_key(std::string_view key) {
		int index = -1;
		std::from_chars(key.data(), key.data() + key.size(), index);
		if (index < 0 || index >= BLADE_COUNT || key != std::to_string(index)) {
			return std::nullopt;
		}
		return index;
	}

	std::string_view _text;
	JsonReader _reader;
	Multivector _value;
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
