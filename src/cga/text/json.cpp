#include "cga/text/json.hpp"

#include "cga/text/json_reader.hpp"
#include "cga/text/number_text.hpp"

#include <bitset>
#include <charconv>

namespace cga {

namespace {

constexpr size_t MAX_JSON_LENGTH = 65536;

bool read_array(JsonReader &reader, Multivector &x) {
	reader.take('[', "'['");
	for (int index = 0; index < BLADE_COUNT; ++index) {
		if (reader.next_is(']')) {
			return reader.fail(reader.position(), "expected 32 numbers, found the end of the array after " + std::to_string(index));
		}
		if (index > 0 && !reader.take(',', "',' or ']'")) {
			return false;
		}
		const std::optional<double> number = reader.read_number();
		if (!number) {
			return false;
		}
		x[index] = *number;
	}
	return reader.take(']', "']' after 32 numbers");
}

// "0" .. "31" without leading zeros; empty for anything else.
std::optional<int> index_of_key(std::string_view key) {
	int index = -1;
	std::from_chars(key.data(), key.data() + key.size(), index);
	return index >= 0 && index < BLADE_COUNT && key == std::to_string(index) ? std::optional(index) : std::nullopt;
}

bool read_object(JsonReader &reader, Multivector &x) {
	reader.take('{', "'{'");
	std::bitset<BLADE_COUNT> seen;
	while (!seen.all()) {
		if (seen.any() && reader.next_is('}')) {
			return reader.fail(reader.position(), "expected 32 numbers, found the end of the object after " + std::to_string(seen.count()));
		}
		if (seen.any() && !reader.take(',', "',' or '}'")) {
			return false;
		}
		if (!reader.next_is('"')) {
			return reader.fail_expected("a key in double quotes");
		}
		const size_t offset = reader.position();
		const std::optional<std::string> key = reader.read_string();
		if (!key || !reader.take(':', "':' after the key")) {
			return false;
		}
		if (*key == "coefficients" && seen.none()) {
			return read_array(reader, x) && reader.take('}', "'}' after the coefficients");
		}
		const std::optional<int> index = index_of_key(*key);
		if (!index) {
			return reader.fail(offset, seen.any() ? "expected a key from \"0\" to \"31\"" : "expected the key \"coefficients\" or keys from \"0\" to \"31\"");
		}
		if (seen[size_t(*index)]) {
			return reader.fail(offset, "the key \"" + *key + "\" occurs twice");
		}
		const std::optional<double> number = reader.read_number();
		if (!number) {
			return false;
		}
		seen.set(size_t(*index));
		x[*index] = *number;
	}
	return reader.take('}', "'}' after 32 numbers");
}

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
	if (text.size() > MAX_JSON_LENGTH) {
		return text_error(text, MAX_JSON_LENGTH, "the text is too long: it has " + std::to_string(text.size()) + " bytes, and at most " + std::to_string(MAX_JSON_LENGTH) + " are accepted");
	}
	JsonReader reader(text);
	Multivector x;
	const bool is_array = reader.next_is('[');
	if (!is_array && !reader.next_is('{')) {
		reader.fail_expected("'[' or '{'");
	} else if ((is_array ? read_array(reader, x) : read_object(reader, x)) && !reader.is_at_end()) {
		reader.fail_expected("the end");
	}
	return reader.error() ? TextResult<Multivector>(text_error(text, reader.error()->offset, reader.error()->message)) : x;
}

} // namespace cga
