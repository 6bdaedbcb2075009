// Hostile texts for everything in src/playground that reads texts of others: expressions, and documents as JSON. As a program
// it mutates right ones, from fixed seeds, so many times as its argument says; with -DLIBFUZZER and -fsanitize=fuzzer it is
// libFuzzer's target. What fails ends it: by a sanitizer, or by an abort where an answer is not as it must be, or late.

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

void demand(bool condition, const char *what, const std::string &text) {
	if (!condition) {
		std::fprintf(stderr, "playground_fuzz: %s\n%s\n", what, text.c_str());
		std::abort();
	}
}

void demand_sound(const playground::Document &document, const std::string &text) {
	for (size_t index = 0; index < document.size(); ++index) {
		const playground::Entry &entry = document.at(index);
		demand(entry.value || !entry.value.error().message.empty(), "neither a value nor an error", text);
		demand(!entry.value || entry.value->is_finite(), "a value is not finite", text);
		demand(!playground::describe(entry).empty(), "no description", text);
	}
}

// Evaluates, edits and renames in a document that defines the names of the seeds.
void fuzz_expression(const std::string &text) {
	playground::Document document;
	demand(document.add("a", "point(1, 2, 3)") && document.add("r", "2") && document.add("x", text) && document.add("after", "x + a"), "an entry is refused", text);
	demand_sound(document, text);
	for (const playground::Parameter &parameter : playground::parameters_of(text)) {
		const cga::Result<std::string, playground::Error> same = playground::with_parameter(text, parameter.name, parameter.literal.value);
		demand(same && *same == text, "setting a parameter to what it is changes the text", text);
	}
	if (document.rename("a", "renamed")) {
		demand(document.rename("renamed", "a").has_value(), "an entry cannot be renamed back", text);
	}
	demand(document.find("x")->text == playground::pasted_expression(text), "renaming there and back changes the text", text);
	demand_sound(document, text);
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
		demand(changed || !changed.error().message.empty(), "neither a text nor an error", text);
		if (changed) {
			const size_t count = playground::parameters_of(*changed).size();
			demand(count > 0, "a parameter was set, and is gone", text + "\n" + *changed);
		}
	}
}

void fuzz_document(const std::string &text) {
	const playground::LoadedDocument loaded = playground::read_document(text);
	demand(loaded.is_document || !loaded.errors.empty(), "no document, and no reason", text);
	playground::Document document;
	demand(document.restore(loaded.state) && document.state() == loaded.state, "a document that was read is not taken as it is", text);
	demand_sound(document, text);
	const playground::LoadedDocument again = playground::read_document(playground::to_json(document.state()));
	demand(again.errors.empty() && again.state == loaded.state, "a document that was written is read differently", text);
	if (document.size() > 1) {
		(void)document.rename(std::string(document.at(0).name), "renamed"); // refused if the name is taken
		demand(document.remove(std::string(document.at(1).name)).has_value(), "an entry cannot be removed", text);
		demand_sound(document, text);
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
		demand(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < MAX_SECONDS, "it took long", text);
	}
	return 0;
}

#ifndef LIBFUZZER

namespace {

// What means something to a parser, in a place where it may not be expected.
const char *const PIECES[] = { "(", ")", "[", "]", "{", "}", "\"", "\\", ",", ":", "deg(", "e1", "1e+999", "-", "point(", "a", "x", "\\ud800", "null", "1e-400", "vector(", "^", "{\"name\": \"", "sphere(", "0", "   " };

void mutate_text(std::string &text, std::mt19937 &random) {
	const size_t at = random() % (text.size() + 1);
	switch (random() % 4) {
		case 0:
			text.insert(at, PIECES[random() % (sizeof(PIECES) / sizeof(PIECES[0]))]);
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
			for (size_t wrong = random() % 6; wrong > 0; --wrong) {
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
