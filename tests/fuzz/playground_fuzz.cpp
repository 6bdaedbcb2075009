// Fuzzes everything in src/playground that parses untrusted text: expressions, and documents as JSON. As a program it mutates
// valid texts from a fixed seed, as many times as its argument says; with -DLIBFUZZER and -fsanitize=fuzzer it is a libFuzzer
// target. A failure ends it: a sanitizer's report, a violated condition, or an input that takes longer than MAX_SECONDS.

#include "mutation.hpp"

#include "playground/document/describe_entry.hpp"
#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"
#include "playground/document/parameters.hpp"
#include "playground/document/pasted_text.hpp"
#include "playground/expression/evaluate.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using fuzz::Bytes;

constexpr double MAX_SECONDS = 5.0;

void require(bool condition, const char *what, const std::string &text) {
	if (!condition) {
		std::fprintf(stderr, "playground_fuzz: %s\n%s\n", what, text.c_str());
		std::abort();
	}
}

void require_valid(const playground::Document &document, const std::string &text) {
	for (size_t index = 0; index < document.size(); ++index) {
		const playground::Entry &entry = document.at(index);
		require(entry.value || !entry.value.error().message.empty(), "neither a value nor an error", text);
		require(!entry.value || entry.value->is_finite(), "a value is not finite", text);
		require(!playground::describe(entry).empty(), "no description", text);
	}
}

// Evaluates, edits and renames in a document that defines the names of the seeds.
void fuzz_expression(const std::string &text) {
	playground::Document document;
	require(document.add("a", "point(1, 2, 3)") && document.add("r", "2") && document.add("x", text) && document.add("after", "x + a"), "a valid entry is rejected", text);
	require_valid(document, text);
	for (const playground::Parameter &parameter : playground::parameters_of(text)) {
		const cga::Result<std::string, playground::Error> same = playground::with_parameter(text, parameter.name, parameter.literal.value);
		require(same && *same == text, "setting a parameter to its own value changes the text", text);
	}
	if (document.rename("a", "renamed")) {
		require(document.rename("renamed", "a").has_value(), "an entry cannot be renamed back", text);
	}
	require(document.find("x")->text == playground::pasted_expression(text), "renaming an entry and back changes the text", text);
	require_valid(document, text);
}

void fuzz_parameter(const std::string &text) {
	for (const playground::Parameter &parameter : playground::parameters_of(text)) {
		playground::LiteralValue value = parameter.literal.value;
		if (double *number = std::get_if<double>(&value)) {
			*number = *number * 0.7 + 1.0;
		} else if (cga::Vector3<double> *vector = std::get_if<cga::Vector3<double>>(&value)) {
			*vector = *vector * 0.3 + cga::Vector3<double>(-1.0, 0.0, 1e-5);
		}
		const cga::Result<std::string, playground::Error> changed = playground::with_parameter(text, parameter.name, value);
		require(changed || !changed.error().message.empty(), "neither a text nor an error", text);
		if (changed) {
			const size_t count = playground::parameters_of(*changed).size();
			require(count > 0, "after a parameter was set, the text has no parameters", text + "\n" + *changed);
		}
	}
}

void fuzz_document(const std::string &text) {
	const playground::LoadedDocument loaded = playground::read_document(text);
	require(loaded.is_document || !loaded.errors.empty(), "neither a document nor an error", text);
	playground::Document document;
	require(document.restore(loaded.state) && document.state() == loaded.state, "restoring a document changes it", text);
	require_valid(document, text);
	const playground::LoadedDocument again = playground::read_document(playground::to_json(document.state()));
	require(again.errors.empty() && again.state == loaded.state, "a document differs after it was written and read", text);
	if (document.size() > 1) {
		(void)document.rename(std::string(document.at(0).name), "renamed"); // rejected if the name is taken
		require(document.remove(std::string(document.at(1).name)).has_value(), "an entry cannot be removed", text);
		require_valid(document, text);
	}
}

const char *const DOCUMENT = R"json({
	"format": "ga_godot_scene",
	"version": 1,
	"attributes": {"title": "Two spheres \u00e4 \ud835\udd38", "speed": 1.5e-3},
	"entries": [
		{"name": "a", "expression": "point(1, 2, 3)", "attributes": {"color": "#ff0000", "label": false}},
		{"name": "r", "expression": "2"},
		{"name": "s", "expression": "sphere(a, r)", "attributes": {"note": "a \"note\"\n"}},
		{"name": "t", "expression": "sphere(e1, r + 1)", "attributes": {"ipns": true, "visible": false}},
		{"name": "m", "expression": "meet(s, t)"},
		{"name": "v", "expression": "motor(e1, rotor(e3, deg(90)), 2)"},
		{"name": "moved", "expression": "sandwich(power(v, 0.5), m)"},
		{"name": "loop", "expression": "pool + 1"},
		{"name": "pool", "expression": "loop"},
		{"name": "x1", "expression": "[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31]"}
	]
}
)json";

const char *const EXPRESSIONS[] = {
	"point(1, -2.5, 3)",
	"!sphere(point(1, 2, 3), 2)",
	"circle(e1 - 0.5 e2, e3, 1.25)",
	"line(a, 2 e1 + e2)",
	"plane(0, 0, 1, 2.5)",
	"motor_from(vector(1, 2, 3), rotor(0, 0, 0, 1), 2)",
	"rotor(e1 + e2, deg(33.3))",
	"interpolate_screw(translator(a), rotor(e3, x), 0.5) * interpolate_linear(1, dilator(2), r)",
	"1 + 2 e12 - 0.5 e1^einf + 3 einf^eo",
	"[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,1e21]",
	"meet(sphere(a, r), sphere(e1, r / 2)) * (a ^ einf) + x",
	"exp(-0.5 * r * e12) | ~a << !a >> a & e12345",
};

struct Target {
	const char *name;
	void (*run)(const std::string &);
	std::vector<std::string> seeds;
};

const Target TARGETS[] = {
	{ "expression", fuzz_expression, { std::begin(EXPRESSIONS), std::end(EXPRESSIONS) } },
	{ "parameter", fuzz_parameter, { std::begin(EXPRESSIONS), std::end(EXPRESSIONS) } },
	{ "document", fuzz_document, { DOCUMENT, "[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31]" } },
};
constexpr size_t TARGET_COUNT = sizeof(TARGETS) / sizeof(TARGETS[0]);

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's entry point
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
	if (size > 0) {
		const std::string text(reinterpret_cast<const char *>(bytes) + 1, size - 1);
		const auto start = std::chrono::steady_clock::now();
		TARGETS[bytes[0] % TARGET_COUNT].run(text);
		require(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < MAX_SECONDS, "an input takes longer than MAX_SECONDS", text);
	}
	return 0;
}

#ifndef LIBFUZZER

namespace {

// Tokens to insert at random positions.
const char *const TOKENS[] = { "(", ")", "[", "]", "{", "}", "\"", "\\", ",", ":", "deg(", "e1", "1e+999", "-", "point(", "a", "x", "\\ud800", "null", "1e-400", "vector(", "^", "{\"name\": \"", "sphere(", "0", "   " };

void mutate_text(std::string &text, std::mt19937 &random) {
	const size_t at = random() % (text.size() + 1);
	switch (random() % 4) {
		case 0:
			text.insert(at, TOKENS[random() % (sizeof(TOKENS) / sizeof(TOKENS[0]))]);
			break;
		case 1:
			text.erase(at, 1 + random() % 8);
			break;
		case 2: {
			const size_t from = random() % (text.size() + 1);
			text.insert(at, std::string(text, from, random() % 40));
			break;
		}
		default: {
			Bytes bytes(text.begin(), text.end());
			fuzz::mutate(bytes, random);
			text.assign(bytes.begin(), bytes.end());
		}
	}
}

} // namespace

int main(int count, char **arguments) {
	const int rounds = count > 1 ? std::atoi(arguments[1]) : 10000;
	std::mt19937 random(20240602);
	for (size_t target = 0; target < TARGET_COUNT; ++target) {
		for (int round = 0; round < rounds; ++round) {
			std::string text = TARGETS[target].seeds[random() % TARGETS[target].seeds.size()];
			for (size_t mutations = random() % 6; mutations > 0; --mutations) {
				mutate_text(text, random);
			}
			const std::string input = char(target) + text;
			LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t *>(input.data()), input.size());
		}
		std::printf("%s: %d inputs\n", TARGETS[target].name, rounds);
	}
	std::printf("[playground_fuzz] %d passed, 0 failed\n", int(TARGET_COUNT));
	return 0;
}

#endif
