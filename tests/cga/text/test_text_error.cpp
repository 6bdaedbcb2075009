#include "cga/text/text_error.hpp"

#include "cga/text/utf8.hpp"

#include <doctest/doctest.h>

using namespace cga;

TEST_CASE("the column of an error counts the characters of its line") {
	const TextError first = text_error("a + b", 4, "expected a number");
	CHECK(first.offset == 4);
	CHECK(first.line == 1);
	CHECK(first.column == 5);
	CHECK(first.describe() == "column 5: expected a number");
	const TextError second = text_error("one\nzwö x", 9, "expected 'y'");
	CHECK(second.line == 2);
	CHECK(second.column == 5);
	CHECK(second.describe() == "line 2, column 5: expected 'y'");
	CHECK(text_error("abc", 3, "").column == 4);
	CHECK(text_error("abc", 100, "").offset == 3);
	CHECK(text_error("", 0, "").column == 1);
	CHECK(text_error("abc\n", 4, "").line == 2);
	CHECK(text_error("abc\n", 4, "").column == 1);
}

TEST_CASE("characters of UTF-8") {
	CHECK(character_at("x", 0).code == 'x');
	CHECK(character_at("ö", 0).code == 0xf6);
	CHECK(character_at("∧", 0).length == 3);
	CHECK(character_at("\xf0\x9f\x98\x80", 0).code == 0x1f600);
	CHECK(character_count("aö∧\xf0\x9f\x98\x80") == 4);
}

TEST_CASE("each invalid byte of UTF-8 counts as a character") {
	for (const std::string_view wrong : { "\x80", "\xff", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8", "\xe2\x88" }) {
		const Character character = character_at(wrong, 0);
		CHECK_FALSE(character.is_valid);
		CHECK(character.length == 1);
		CHECK(character_count(wrong) == int(wrong.size()));
	}
}

TEST_CASE("describe_character() is always printable") {
	CHECK(describe_character("x", 0) == "'x'");
	CHECK(describe_character("∧", 0) == "'∧'");
	CHECK(describe_character("x", 1) == "the end");
	CHECK(describe_character("\xff", 0) == "the byte 0xff");
	CHECK(describe_character(std::string_view("\0", 1), 0) == "the control character 0x00");
	CHECK(describe_character("\x1b", 0) == "the control character 0x1b");
}

TEST_CASE("describe_errors() describes errors in any order as text_error() does") {
	const std::string text = "one\nzwö x\n\n∧∧ y\n";
	std::vector<OffsetError> errors;
	for (const size_t offset : { 9, 0, 17, 4, 10, 100, 9, 3, 11 }) {
		errors.push_back({ "error " + std::to_string(errors.size()), offset });
	}
	const std::vector<std::string> descriptions = describe_errors(text, errors);
	REQUIRE(descriptions.size() == errors.size());
	for (size_t index = 0; index < errors.size(); ++index) {
		CHECK(descriptions[index] == text_error(text, errors[index].offset, errors[index].message).describe());
	}
	CHECK(describe_errors(text, {}).empty());
}

TEST_CASE("shortened() keeps short texts, and cuts long ones between characters") {
	CHECK(shortened("") == "");
	CHECK(shortened(std::string(MAX_QUOTED_LENGTH, 'x')) == std::string(MAX_QUOTED_LENGTH, 'x'));
	CHECK(shortened(std::string(MAX_QUOTED_LENGTH + 1, 'x')) == std::string(MAX_QUOTED_LENGTH, 'x') + "...");
	CHECK(shortened(std::string(MAX_QUOTED_LENGTH - 1, 'x') + "∧") == std::string(MAX_QUOTED_LENGTH - 1, 'x') + "...");
}
