// What a drag costs: 200 objects of which each depends on the one that is dragged, through a chain of 50. Beside a full
// evaluation, which parses and computes every entry, as a playground without dependencies does after each change.

#include "playground/document/document.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/parser.hpp"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

namespace {

constexpr int LEVELS = 50;

// A point that is carried on from level to level, and what is built on it there.
playground::DocumentState chain() {
	playground::DocumentState state;
	state.entries.push_back({ "p0", "point(0.3, 0.2, 0.1)", {} });
	for (int level = 1; level <= LEVELS; ++level) {
		const std::string here = std::to_string(level);
		const std::string before = std::to_string(level - 1);
		state.entries.push_back({ "p" + here, "sandwich(translator(0.1, 0.02, 0), p" + before + ")", {} });
		state.entries.push_back({ "s" + here, "sphere(p" + here + ", 1.5)", {} });
		state.entries.push_back({ "l" + here, "p" + before + " ^ p" + here + " ^ einf", {} });
		state.entries.push_back({ "c" + here, "s" + here + " & plane(e3, 0.2)", {} });
	}
	return state;
}

playground::Document document_of_chain() {
	playground::Document document;
	if (!document.restore(chain())) {
		std::abort();
	}
	return document;
}

cga::Vector3<double> dragged(int step) {
	return { 0.3 + 0.001 * (step % 1000), 0.2, 0.1 };
}

void reevaluate_chain(benchmark::State &bench) {
	playground::Document document = document_of_chain();
	int step = 0;
	for ([[maybe_unused]] auto _ : bench) {
		const playground::ChangeResult change = document.set_parameter("p0", "position", dragged(++step));
		if (!change || change->size() != document.size()) {
			std::abort();
		}
	}
}

// The last of the chain: what does not depend on it costs nothing.
void reevaluate_end(benchmark::State &bench) {
	playground::Document document = document_of_chain();
	if (!document.set_expression("p50", "point(0.3, 0.2, 0.1)")) {
		std::abort();
	}
	int step = 0;
	for ([[maybe_unused]] auto _ : bench) {
		const playground::ChangeResult change = document.set_parameter("p50", "position", dragged(++step));
		if (!change || change->size() != 4) {
			std::abort();
		}
	}
}

void evaluate_all(benchmark::State &bench) {
	playground::DocumentState state = chain();
	int step = 0;
	for ([[maybe_unused]] auto _ : bench) {
		state.entries[0].text = "point(" + std::to_string(dragged(++step).x) + ", 0.2, 0.1)";
		playground::Variables variables;
		for (const playground::EntryState &entry : state.entries) {
			variables.insert_or_assign(entry.name, *playground::evaluate(*playground::parse(entry.text), variables));
		}
		benchmark::DoNotOptimize(variables);
	}
}

BENCHMARK(reevaluate_chain)->Name("reevaluate_chain/ga_godot/200")->Unit(benchmark::kMicrosecond);
BENCHMARK(evaluate_all)->Name("reevaluate_chain/full_evaluation/200")->Unit(benchmark::kMicrosecond);
BENCHMARK(reevaluate_end)->Name("reevaluate_end_of_chain/ga_godot/200")->Unit(benchmark::kMicrosecond);
BENCHMARK(evaluate_all)->Name("reevaluate_end_of_chain/full_evaluation/200")->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
