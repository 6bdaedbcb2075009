#include "cga/text/json_reader.hpp"

#include <doctest/doctest.h>

using namespace cga;

namespace {

std::string described(std::string_view json, const JsonReader &reader) {
	return text_error(json, reader.error()->offset, reader.error()->message).describe();
}

std::string string_of(std::string_view json) {
	JsonReader reader(json);
	const std::optional<std::string> value = reader.read_string();
	return value ? *value : "error: " + described(json, reader);
}

std::string skipped(std::string_view json) {
	JsonReader reader(json);
	if (!reader.skip_value()) {
		return described(json, reader);
	}
	return reader.is_at_end() ? "all" : "up to " + std::to_string(reader.position());
}

std::string written(std::string_view text) {
	std::string json;
	append_json_string(json, text);
	return json;
}

} // namespace

TEST_CASE("read_string() resolves every escape") {
	CHECK(string_of(" \"a ä 𝔸\"") == "a ä 𝔸");
	CHECK(string_of(R"("\"\\\/\b\f\n\r\t")") == "\"\\/\b\f\n\r\t");
	CHECK(string_of(R"("\u0041\u00e4\u20ac\ud835\udd38")") == "Aä€𝔸");
	CHECK(string_of(R"("\u00E4\u0000")") == std::string("ä\0", 3));
	CHECK(string_of("x") == "error: column 1: expected a string in double quotes, found 'x'");
	CHECK(string_of("\"x") == "error: column 3: expected '\"' at the end of the string, found the end");
	CHECK(string_of("\"x\n\"") == "error: column 3: expected a character or '\"', found the control character 0x0a");
	CHECK(string_of("\"\xff\"") == "error: column 2: expected a character or '\"', found the byte 0xff");
	for (const char *bad : { R"("\x")", R"("\u12")", R"("\u12g4")", "\"\\" }) {
		CHECK(string_of(bad) == R"(error: column 2: expected one of \" \\ \/ \b \f \n \r \t or \u and four hexadecimal digits)");
	}
	for (const char *half : { R"("\ud835")", R"("\ud835\n")", R"("\ud835\u0041")", R"("\udd38")" }) {
		CHECK(string_of(half) == "error: column 2: expected a character, found an unpaired UTF-16 surrogate");
	}
}

TEST_CASE("append_json_string() writes strings that read back as the same") {
	CHECK(written("a\"\\\n\x01ä") == R"("a\"\\\n\u0001ä")");
	CHECK(written("\xff") == "\"\xef\xbf\xbd\"");
	std::string all;
	for (int code = 0; code < 128; ++code) {
		all += char(code);
	}
	CHECK(string_of(written(all)) == all);
}

TEST_CASE("skip_value() skips values of any type") {
	for (const char *value : { "1", "-0.5e+3", "\"a]\"", "true", "false", "null", "[]", "{}", "[1, [2, {}], {\"a\": [], \"b\": {\"c\": null}}]", " {\"a\" : 1 , \"b\" : 2} " }) {
		CHECK_MESSAGE(skipped(value) == "all", value);
	}
	CHECK(skipped("[1] 2") == "up to 4");
	CHECK(skipped("") == "column 1: expected a number, found the end");
	CHECK(skipped("[1") == "column 3: expected ',' or ']', found the end");
	CHECK(skipped("[1,]") == "column 4: expected a number, found ']'");
	CHECK(skipped("[1}") == "column 3: expected ',' or ']', found '}'");
	CHECK(skipped("{1}") == "column 2: expected a string in double quotes, found '1'");
	CHECK(skipped("{\"a\" 1}") == "column 6: expected ':' after the key, found '1'");
	CHECK(skipped("{\"a\": 1 \"b\"}") == "column 9: expected ',' or '}', found '\"'");
	CHECK(skipped("nil") == "column 1: expected null, found 'n'");
	CHECK(skipped("tru") == "column 1: expected true or false, found 't'");
	CHECK(skipped(std::string(256, '[') + std::string(256, ']')) == "all");
	CHECK(skipped(std::string(257, '[')) == "column 257: the value is nested too deeply; at most 256 levels are accepted");
}

TEST_CASE("the first error is kept until restart_at()") {
	JsonReader reader("[x, 5]");
	CHECK(reader.take('[', "'['"));
	CHECK(!reader.read_number());
	CHECK(!reader.take('x', "'x'"));
	CHECK(reader.error()->message == "expected a number, found 'x'");
	CHECK(reader.error()->offset == 1);
	reader.restart_at(4);
	CHECK(reader.read_number() == 5.0);
	CHECK(!reader.error());
}
