#include "playground/document/document_json.hpp"

#include "playground/document/document.hpp"

#include <doctest/doctest.h>

using namespace playground;
using Texts = std::vector<std::string>;

namespace {

const char *const EXAMPLE = R"json({
	"format": "ga_godot_scene",
	"version": 1,
	"attributes": {"interpolation/mode": "screw"},
	"entries": [
		{"name": "a", "expression": "point(1, 2, 3)", "attributes": {"color": "#ff0000", "label": false, "size": 2.5}},
		{"name": "b", "expression": "a ^ einf"}
	]
}
)json";

// One error per line.
std::string joined(const Texts &errors) {
	std::string text;
	for (const std::string &error : errors) {
		text += (text.empty() ? "" : "\n") + error;
	}
	return text;
}

Texts names_of(const LoadedDocument &loaded) {
	Texts names;
	for (const EntryState &entry : loaded.state.entries) {
		names.push_back(entry.name);
	}
	return names;
}

std::string with_entries(const std::string &entries) {
	return "{\"version\": 1, \"entries\": [" + entries + "]}";
}

std::string array(int count) {
	std::string text = "[1";
	for (int index = 1; index < count; ++index) {
		text += "," + std::to_string(index);
	}
	return text + "]";
}

} // namespace

TEST_CASE("a document is read, and written as the same text") {
	const LoadedDocument loaded = read_document(EXAMPLE);
	CHECK(joined(loaded.errors) == "");
	CHECK(loaded.is_document);
	CHECK(names_of(loaded) == Texts{ "a", "b" });
	CHECK(loaded.state.entries[0].attributes.at("size") == AttributeValue(2.5));
	CHECK(!is_set(loaded.state.entries[0].attributes, "label"));
	CHECK(to_json(loaded.state) == EXAMPLE);
	CHECK(to_json({}) == "{\n\t\"format\": \"ga_godot_scene\",\n\t\"version\": 1,\n\t\"entries\": []\n}\n");
	CHECK(read_document(to_json({})).is_document);
}

TEST_CASE("any text survives writing and reading") {
	DocumentState state;
	state.entries.push_back({ "größe", "1 +\n\t\"x\\ ∧ \x01 {\"name\": 1}", {} });
	state.entries[0].attributes["note"] = std::string("𝔸 \r\b\f / \\u0041 {\"name\"");
	state.entries[0].attributes["x"] = 0.1 + 0.2;
	const LoadedDocument loaded = read_document(to_json(state));
	CHECK(joined(loaded.errors) == "");
	CHECK(loaded.state == state);
}

TEST_CASE("invalid UTF-8 is replaced when it is written") {
	DocumentState state;
	state.entries.push_back({ "a", "1 \xff", {} });
	const LoadedDocument loaded = read_document(to_json(state));
	CHECK(joined(loaded.errors) == "");
	CHECK(loaded.state.entries[0].text == "1 \xef\xbf\xbd");
}

TEST_CASE("invalid entries are skipped, and their positions reported") {
	const auto errors = [](const std::string &entries) { return read_document(with_entries(entries)).errors; };
	const std::string good = "{\"name\": \"z\", \"expression\": \"1\"}";
	CHECK(joined(errors(good)) == "");
	CHECK(joined(errors("{\"expression\": \"1\"}, " + good)) == "column 28: entry skipped: a name must have at least one character");
	CHECK(joined(errors("{\"name\": \"e1\", \"expression\": \"1\"}")) == "column 28: entry skipped: 'e1' is a constant; choose another name");
	CHECK(joined(errors("{\"name\": \"a\"}")) == "column 28: entry 'a' skipped: it has no expression");
	CHECK(joined(errors(good + "," + good)) == "column 61: entry 'z' skipped: an earlier entry has the same name");
	CHECK(joined(errors("{\"name\": \"a\", \"expression\": 5}, " + good)) == "column 56: entry 'a' skipped: expected a string in double quotes, found '5'");
	CHECK(joined(errors("17, " + good)) == "column 28: entry skipped: expected '{', found '1'");
	CHECK(joined(errors(good + " " + good)) == "column 61: expected ',' or ']', found '{'\ncolumn 61: entry 'z' skipped: an earlier entry has the same name");
	for (const std::string broken : { "{\"name\": \"a\", \"expression\": \"1}", "{\"name\": \"a\", \"expression\": \"1\", \"x\": [}", "{\"name\": \"\\q\"}", "nonsense", "{\"name\"" }) {
		const LoadedDocument loaded = read_document("{\"entries\": [\n{\"name\": \"before\", \"expression\": \"1\"},\n" + broken + ",\n" + good + "\n]}");
		CHECK_MESSAGE(names_of(loaded) == (Texts{ "before", "z" }), broken);
		REQUIRE(!loaded.errors.empty());
		CHECK_MESSAGE(loaded.errors[0].rfind("line 3, column ", 0) == 0, loaded.errors[0]);
	}
}

TEST_CASE("a truncated document keeps its complete entries") {
	const std::string text = EXAMPLE;
	for (size_t size = 0; size < text.size() - 2; ++size) {
		const LoadedDocument loaded = read_document(text.substr(0, size));
		CHECK(!loaded.errors.empty());
		CHECK(loaded.state.entries.size() == (size < text.find("\n\t\t{\"name\": \"b\"") - 1 ? 0 : (size < text.find("\n\t]") ? 1 : 2)));
	}
}

TEST_CASE("texts that are not documents, and documents of other versions") {
	const auto errors = [](const char *text) { return read_document(text).errors; };
	CHECK(joined(errors("")) == "column 1: expected '{' before a document or '[' before 32 coefficients, found the end");
	CHECK(joined(errors("{}")) == "column 1: expected the key \"entries\" in the document");
	CHECK(!read_document("{\"x\": 1}").is_document);
	CHECK(joined(errors("{\"format\": \"other\", \"entries\": []}")) == "column 12: expected the format \"ga_godot_scene\"; this file has another format");
	CHECK(!read_document("{\"format\": \"other\", \"entries\": []}").is_document);
	CHECK(joined(errors("{\"version\": 2, \"entries\": []}")) == "column 13: the document has a newer version than 1, the latest that this GA-Godot reads; update GA-Godot");
	CHECK(joined(errors("{\"version\": 0.5, \"entries\": []}")) == "column 13: the version must be an integer of at least 1");
	CHECK(joined(errors("{\"entries\": [], \"later\": {\"a\": [1, {\"b\": null}]}}")) == "");
	CHECK(joined(errors("{\"entries\": []} x")) == "column 17: expected the end, found 'x'");
	CHECK(joined(errors("{\"entries\": [{\"name\": \"a\", \"expression\": \"1\", \"attributes\": {\"visible\": 3, \"x\": [1], \"y\": true}}]}")) == "column 73: attribute of 'a' skipped: the attribute 'visible' must be a bool, not a number\ncolumn 81: expected a string, a number, true, false or null as attribute");
	const std::string deep(100000, '[');
	CHECK(joined(errors(("{\"x\": " + deep).c_str())) == "column 263: the value is nested too deeply; at most 256 levels are accepted");
	CHECK(joined(read_document(std::string(MAX_DOCUMENT_LENGTH + 1, ' ')).errors) == "column 1: the document is too long: it has 16777217 bytes, and at most 16777216 are accepted");
}

TEST_CASE("multivectors in the format of ganja.js are a document") {
	CHECK(names_of(read_document(array(32))) == Texts{ "x1" });
	CHECK(names_of(read_document(" [" + array(32) + ", " + array(32) + "] ")) == Texts{ "x1", "x2" });
	const LoadedDocument loaded = read_document("[" + array(31) + "," + array(32) + "]");
	CHECK(names_of(loaded) == Texts{ "x1" });
	CHECK(joined(loaded.errors) == "column 85: multivector skipped: expected 32 numbers, found the end of the array after 31");
	CHECK(joined(read_document("[1, 2]").errors) == "column 6: multivector skipped: expected 32 numbers, found the end of the array after 2");
	CHECK(!read_document("[]").is_document);
}
