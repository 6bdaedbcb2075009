// How long large documents take to open or to be refused: reading and evaluating those of the tests at 16 MiB, and the two
// that were once measured at smaller sizes.

#include "../../playground/document/large_documents.hpp"

#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"

#include <benchmark/benchmark.h>

#include <string>

namespace {

using playground_test::LargeDocument;

void open_document(benchmark::State &bench, const std::string &json) {
	for ([[maybe_unused]] auto _ : bench) {
		playground::LoadedDocument loaded = playground::read_document(json);
		playground::Document document;
		benchmark::DoNotOptimize(document.restore(std::move(loaded.state)));
	}
}

// The size in bytes is the n of the row.
void add_rows(const LargeDocument &kind, size_t count) {
	const std::string name = "open_document/" + std::string(kind.name) + "/" + std::to_string(kind.json(count).size());
	benchmark::RegisterBenchmark(name.c_str(), [&kind, count](benchmark::State &bench) { open_document(bench, kind.json(count)); })->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool ARE_REGISTERED = [] {
	for (const LargeDocument &kind : playground_test::LARGE_DOCUMENTS) {
		// At most 16 MiB, and at most as many entries as there may be where they refer to each other.
		const bool is_graph = std::string(kind.name) == "chain" || std::string(kind.name) == "cycle" || std::string(kind.name) == "star";
		size_t count = is_graph ? playground::MAX_ENTRIES : playground::MAX_DOCUMENT_LENGTH / kind.unit + 1;
		while (kind.json(count).size() > playground::MAX_DOCUMENT_LENGTH) {
			count -= count / 50 + 1;
		}
		add_rows(kind, count);
	}
	add_rows(playground_test::LARGE_DOCUMENTS[0], 20000); // refused entries
	add_rows(playground_test::LARGE_DOCUMENTS[5], 70000); // valid entries
	return true;
}();

} // namespace
