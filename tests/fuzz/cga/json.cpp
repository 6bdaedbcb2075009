// Multivectors as JSON, the pull parser behind it, and strings that are written and read.

#include "../input.hpp"

#include "cga/text/json.hpp"
#include "cga/text/json_reader.hpp"
#include "cga/text/text.hpp"

#include <cmath>

namespace {

using fuzz::require;

void read_multivector(const std::string &text) {
	const cga::TextResult<cga::Multivector> read = cga::from_json(text);
	if (!read) {
		require(!read.error().message.empty() && !read.error().describe().empty(), "an error has no message", text);
		require(read.error().offset <= text.size(), "the position of an error is not in the text", text);
		return;
	}
	require(read->is_finite(), "a coefficient is not finite", text);
	const cga::TextResult<cga::Multivector> again = cga::from_json(cga::to_json(*read));
	require(again && *again == *read, "a multivector differs after it was written and read", text);
	require(!cga::to_text(*read).empty() && !cga::to_text(*read, true).empty() && !cga::to_latex(*read).empty(), "a multivector has no text", text);
}

void read_values(const std::string &text) {
	cga::JsonReader skipping(text);
	if (skipping.skip_value()) {
		require(!skipping.error() && skipping.position() <= text.size(), "a skipped value has an error", text);
	} else {
		require(skipping.error().has_value(), "a refused value has no error", text);
	}
	cga::JsonReader numbers(text);
	if (const auto number = numbers.read_number()) {
		require(std::isfinite(*number), "a number is not finite", text);
	}
	cga::JsonReader strings(text);
	if (const auto string = strings.read_string()) {
		std::string written;
		cga::append_json_string(written, *string);
		cga::JsonReader again(written);
		const auto read = again.read_string();
		require(read && *read == *string && again.is_at_end(), "a string differs after it was written and read", text);
	}
	std::string written;
	cga::append_json_string(written, text);
	cga::JsonReader again(written);
	require(again.read_string().has_value() && again.is_at_end(), "a written string cannot be read", text);
}

} // namespace

void fuzz::run(Input input) {
	const std::string text = input.rest_text();
	read_multivector(text);
	read_values(text);
}
