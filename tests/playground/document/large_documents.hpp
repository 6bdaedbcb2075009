#pragma once

#include <functional>
#include <string>

// Large documents as JSON, for the tests and the benchmark of the time that reading them takes.

namespace playground_test {

using Part = std::function<std::string(size_t)>;

// `start`, the parts 0 .. count - 1 with commas and line breaks between them, `end`.
inline std::string list(size_t count, const Part &part, const std::string &start = "{\"entries\": [\n", const std::string &end = "\n]}") {
	std::string text = start;
	for (size_t index = 0; index < count; ++index) {
		text += (index > 0 ? ",\n" : "") + part(index);
	}
	return text + end;
}

inline std::string entry(const std::string &name, const std::string &expression) {
	return "{\"name\": \"" + name + "\", \"expression\": \"" + expression + "\"}";
}

inline std::string name_of(size_t index) {
	return "a" + std::to_string(index);
}

inline std::string repeated(const std::string &text, size_t count) {
	std::string all;
	all.reserve(text.size() * count);
	for (size_t index = 0; index < count; ++index) {
		all += text;
	}
	return all;
}

struct LargeDocument {
	const char *name;
	size_t unit; // bytes for each of `count`, about
	std::string (*json)(size_t count);
};

inline std::string same_entry(const std::string &text, size_t count) {
	return list(count, [&text](size_t) { return text; });
}

inline std::string entries_with(size_t count, const Part &expression) {
	return list(count, [&expression](size_t index) { return entry(name_of(index), expression(index)); });
}

inline std::string attributes_with(size_t count, const Part &attribute) {
	return list(count, attribute, "{\"attributes\": {", "}, \"entries\": []}");
}

// Each kind once took time in proportion to the square of its size, or might.
inline constexpr LargeDocument LARGE_DOCUMENTS[] = {
	{ "refused_entries", 30, [](size_t count) { return same_entry("{\"name\":\"e1\",\"expression\":1}", count); } },
	{ "refused_names", 37, [](size_t count) { return same_entry("{\"name\": \"e1\", \"expression\": \"1\"}", count); } },
	{ "duplicate_names", 36, [](size_t count) { return same_entry(entry("a", "1"), count); } },
	{ "empty_entries", 4, [](size_t count) { return same_entry("{}", count); } },
	{ "broken_entries", 8, [](size_t count) { return "{\"entries\": [" + repeated("{\"name\":", count); } },
	{ "valid_entries", 40, [](size_t count) { return entries_with(count, [](size_t) { return "1"; }); } },
	{ "chain", 45, [](size_t count) { return entries_with(count, [](size_t index) { return name_of(index + 1); }); } },
	{ "cycle", 45, [](size_t count) { return entries_with(count, [count](size_t index) { return name_of((index + 1) % count); }); } },
	{ "star", 41, [](size_t count) { return entries_with(count, [](size_t index) { return index > 0 ? "a0" : "1"; }); } },
	{ "missing_names", 45, [](size_t count) { return entries_with(count, [](size_t index) { return "b" + std::to_string(index); }); } },
	{ "attributes", 13, [](size_t count) { return attributes_with(count, [](size_t index) { return "\"" + name_of(index) + "\": 1"; }); } },
	{ "refused_attributes", 7, [](size_t count) { return attributes_with(count, [](size_t) { return "\"\": 1"; }); } },
	{ "versions", 15, [](size_t count) { return list(count, [](size_t) { return "\"version\": 9"; }, "{", ", \"entries\": []}"); } },
	{ "multivectors", 66, [](size_t count) { return list(count, [](size_t) { return "[" + repeated("0,", 31) + "0]"; }, "[", "]"); } },
	{ "refused_multivectors", 4, [](size_t count) { return list(count, [](size_t) { return "[]"; }, "[", "]"); } },
	{ "string", 1, [](size_t count) { return "{\"attributes\": {\"note\": \"" + std::string(count, 'x') + "\"}, \"entries\": []}"; } },
	{ "name", 1, [](size_t count) { return same_entry(entry(std::string(count, 'x'), "1"), 1); } },
	{ "number", 1, [](size_t count) { return "{\"x\": 0." + std::string(count, '0') + "1, \"entries\": []}"; } },
	{ "expression", 2, [](size_t count) { return same_entry(entry("a", repeated("1+", count) + "1"), 1); } },
	{ "sums", 16020, [](size_t count) { return entries_with(count, [](size_t) { return repeated("1+", 8000) + "1"; }); } },
	{ "products", 16020, [](size_t count) { return entries_with(count, [](size_t) { return repeated("E*", 8000) + "E"; }); } },
	{ "calls", 16020, [](size_t count) { return entries_with(count, [](size_t) { return repeated("exp(E)+", 2285) + "1"; }); } },
	{ "nesting", 1, [](size_t count) { return "{\"x\": " + std::string(count, '['); } },
	{ "nested_expressions", 440, [](size_t count) { return entries_with(count, [](size_t) { return std::string(200, '(') + "1" + std::string(200, ')'); }); } },
	{ "keys", 8, [](size_t count) { return list(count, [](size_t) { return "\"x\": 1"; }, "{", ", \"entries\": []}"); } },
	{ "spaces", 1, [](size_t count) { return std::string(count, ' '); } },
};

} // namespace playground_test
