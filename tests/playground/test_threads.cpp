#include "../harness/threads.hpp"
#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"
#include "playground/drawing/figure.hpp"
#include "playground/expression/evaluate.hpp"

#include <doctest/doctest.h>

#include <string>

// Expressions, drawing, and documents of different threads share only tables that no call changes; with the thread sanitizer,
// races fail.

static constexpr size_t THREADS = 4;

TEST_CASE("threads: expressions and figures") {
	const auto work = [](size_t) {
		std::string text;
		for (const char *expression : { "sphere(point(1, 2, 3), 2)", "meet(sphere(point(0, 0, 0), 2), plane(0, 1, 0, 1))", "exp(0.3 * e12) + log(1)", "unknown(1)" }) {
			const cga::TextResult<cga::Multivector> value = playground::evaluate(std::string_view(expression));
			text += value ? std::to_string(value->norm_squared()) + std::to_string(playground::drawing::figure_of(*value, false).parts.size()) : value.error().describe();
		}
		return text;
	};
	const std::string expected = work(0);
	for (const std::string &result : harness::run_in_threads(THREADS, work)) {
		CHECK(result == expected);
	}
}

TEST_CASE("threads: each with its own document") {
	const auto work = [](size_t seed) {
		playground::Document document;
		(void)document.add("p0", "point(1, 2, " + std::to_string(seed) + ")");
		for (int i = 1; i < 30; ++i) {
			(void)document.add("p" + std::to_string(i), "p" + std::to_string(i - 1) + " + p0");
		}
		for (int i = 0; i < 20; ++i) {
			(void)document.set_expression("p0", "point(" + std::to_string(i) + ", 2, " + std::to_string(seed) + ")");
		}
		(void)document.rename("p3", "q");
		(void)document.remove("p7");
		return playground::to_json(document.state()) + std::to_string(document.dependents_of("q").size());
	};
	const std::vector<std::string> results = harness::run_in_threads(THREADS, work);
	for (size_t i = 0; i < THREADS; ++i) {
		CHECK(results[i] == work(i));
	}
}
