#include "large_documents.hpp"

#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <ctime>

using namespace playground;
using namespace playground_test;

namespace {

double processor_seconds() {
	timespec time{};
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
	return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double resolution_of_clock() {
	timespec step{};
	clock_getres(CLOCK_THREAD_CPUTIME_ID, &step);
	return double(step.tv_sec) + 1e-9 * double(step.tv_nsec);
}

// The shortest of several runs. `prepare` is not measured; its result is passed to `run`.
template <class Prepare, class Run>
double seconds(Prepare prepare, Run run) {
	constexpr int RUNS = 5;
	double shortest = 1e9;
	for (int repeat = 0; repeat < RUNS; ++repeat) {
		auto prepared = prepare();
		const double start = processor_seconds();
		run(prepared);
		shortest = std::min(shortest, processor_seconds() - start);
	}
	return shortest;
}

// How many times longer work of 16 times the size takes: 16 if the time is linear, 256 if it is quadratic. A floor keeps out
// what the clock cannot resolve, which is much on Windows; caches and a busy machine raise a linear 16 to 30 or 40.
constexpr size_t GROWTH = 16;
constexpr double MAX_RATIO = 80.0;
const double FLOOR = std::max(1e-4, resolution_of_clock());

template <class Prepare, class Run>
double growth(size_t count, Prepare prepare, Run run) {
	const double small = seconds([&] { return prepare(count); }, run);
	const double large = seconds([&] { return prepare(GROWTH * count); }, run);
	return large / std::max(small, FLOOR);
}

void open(const std::string &json) {
	Document document;
	LoadedDocument loaded = read_document(json);
	(void)document.restore(std::move(loaded.state));
}

Document document_of(size_t count, const Part &expression) {
	DocumentState state;
	for (size_t index = 0; index < count; ++index) {
		state.entries.push_back({ name_of(index), expression(index), {} });
	}
	Document document;
	REQUIRE(document.restore(std::move(state)));
	return document;
}

std::string first_or_one(size_t index) {
	return index > 0 ? "a0" : "1";
}

} // namespace

TEST_CASE("the time to open a document is proportional to its size") {
	for (const LargeDocument &kind : LARGE_DOCUMENTS) {
		const size_t count = std::max<size_t>(1, 30000 / kind.unit);
		const double ratio = growth(count, [&kind](size_t size) { return kind.json(size); }, open);
		CHECK_MESSAGE(ratio < MAX_RATIO, kind.name, ": ", ratio);
	}
}

TEST_CASE("a cycle costs no more than a chain, however long") {
	constexpr size_t COUNT = 60000;
	const auto time_of = [](const Part &expression) {
		return seconds([&expression] { return read_document(entries_with(COUNT, expression)); }, [](LoadedDocument &loaded) {
			Document document;
			REQUIRE(document.restore(std::move(loaded.state))); });
	};
	const double chain = time_of([](size_t index) { return name_of(index + 1); });
	const double cycle = time_of([](size_t index) { return name_of((index + 1) % COUNT); });
	CHECK_MESSAGE(cycle < 1.8 * chain + FLOOR, cycle, " and ", chain);
}

TEST_CASE("the time of edits is proportional to their number") {
	const auto independent = [](size_t count) { return document_of(count, [](size_t) { return "1"; }); };
	const auto star = [](size_t count) { return document_of(count, first_or_one); };
	const auto empty = [](size_t count) { return std::make_pair(count, Document()); };
	const double adding = growth(1000, empty, [](std::pair<size_t, Document> &work) {
		for (size_t index = 0; index < work.first; ++index) {
			REQUIRE(work.second.add(name_of(index), "b" + name_of(index)));
		}
	});
	CHECK(adding < MAX_RATIO);
	const double editing = growth(4000, star, [](Document &document) {
		for (size_t index = document.size() - 1; index > 0; --index) {
			REQUIRE(document.set_expression(document.at(index).name, "2 a0"));
		}
	});
	CHECK(editing < MAX_RATIO);
	const double renaming = growth(4000, star, [](Document &document) { REQUIRE(document.rename("a0", "b")); });
	CHECK(renaming < MAX_RATIO);
	const double removing = growth(4000, star, [](Document &document) { REQUIRE(document.remove("a0")); });
	CHECK(removing < MAX_RATIO);
	const double annotating = growth(1000, independent, [](Document &document) {
		const size_t count = document.size();
		for (size_t index = 0; index < count; ++index) {
			REQUIRE(document.set_attribute("a0", name_of(index), 1.0));
		}
	});
	CHECK(annotating < MAX_RATIO);
}

TEST_CASE("what an error repeats of the text is short") {
	const std::string name(1000000, 'x');
	Document document;
	const auto is_short = [](const std::string &message) { return message.size() < 1200; };
	CHECK(is_short(document.add(name, "1").error().message));
	CHECK(is_short(document.set_expression(name, "1").error().message));
	CHECK(is_short(document.set_parameter(name, "x", 1.0).error().message));
	CHECK(is_short(read_document(same_entry(entry(name, "1"), 1)).errors.at(0)));
	for (const std::string &text : { std::string(16000, 'x'), std::string(16000, 'x') + "(1)", "1 " + std::string(16000, 'x'), "1" + std::string(15000, '0') + "e12", "1e" + std::string(15000, '9') }) {
		REQUIRE(document.add("a", text));
		REQUIRE(!document.find("a")->value);
		CHECK(is_short(document.find("a")->value.error().message));
		REQUIRE(document.set_expression("a", "1"));
		REQUIRE(document.remove("a"));
	}
}

TEST_CASE("errors beyond the first hundred are counted") {
	CHECK(read_document(same_entry("{}", 100)).errors.size() == 100);
	CHECK(read_document(same_entry("{}", 101)).errors.back() == "and 1 more error");
	CHECK(read_document(same_entry("{}", 350)).errors.back() == "and 250 more errors");
	// An error of an attribute comes before that of its entry, and keeps its own place.
	const LoadedDocument loaded = read_document("{\"entries\": [\n{\"name\": \"e1\",\n\"expression\": \"1\", \"attributes\": {\"\": 1}}]}");
	CHECK(loaded.errors.size() == 2);
	CHECK(loaded.errors[0].rfind("line 3, column 39: attribute of 'e1' skipped: ", 0) == 0);
	CHECK(loaded.errors[1] == "line 2, column 1: entry skipped: 'e1' is a constant; choose another name");
}
