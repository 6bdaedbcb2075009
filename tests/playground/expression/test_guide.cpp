// Checks the examples and the function tables of docs/guides/expressions.md. Run from the repository's root.

#include "cga/text/text.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/functions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace playground;
using cga::Multivector;

namespace {

constexpr const char *GUIDE = "docs/guides/expressions.md";

std::string guide() {
	std::ifstream file(GUIDE);
	REQUIRE_MESSAGE(file.good(), "cannot read ", GUIDE, "; run the tests from the repository's root");
	std::ostringstream text;
	text << file.rdbuf();
	return text.str();
}

// The lines of all blocks marked "expressions".
std::vector<std::string> examples() {
	std::istringstream lines(guide());
	std::vector<std::string> result;
	bool inside = false;
	for (std::string line; std::getline(lines, line);) {
		if (line.compare(0, 3, "```") == 0) {
			inside = line == "```expressions";
		} else if (inside) {
			result.push_back(line);
		}
	}
	return result;
}

std::string in_table(std::string text) {
	for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
		text.insert(at, "\\");
	}
	return text;
}

} // namespace

TEST_CASE("every example of the guide has the stated value or error") {
	const std::string error_mark = " error: ";
	const std::string equals_mark = " = ";
	int equalities = 0;
	int errors = 0;
	for (const std::string &example : examples()) {
		CAPTURE(example);
		if (const size_t error = example.find(error_mark); error != std::string::npos) {
			const cga::TextResult<Multivector> result = evaluate(example.substr(0, error));
			REQUIRE_FALSE(result.has_value());
			CHECK(result.error().describe() == example.substr(error + error_mark.size()));
			++errors;
			continue;
		}
		const size_t equals = example.find(equals_mark);
		REQUIRE(equals != std::string::npos);
		const cga::TextResult<Multivector> left = evaluate(example.substr(0, equals));
		const cga::TextResult<Multivector> right = evaluate(example.substr(equals + equals_mark.size()));
		REQUIRE_MESSAGE(left.has_value(), left.error().describe());
		REQUIRE_MESSAGE(right.has_value(), right.error().describe());
		const double size = std::max({ 1.0, left->max_abs(), right->max_abs() });
		CHECK_MESSAGE(left->is_equal_approx(*right, 1e-14 * size), cga::to_text(*left), " is not ", cga::to_text(*right));
		++equalities;
	}
	CHECK(equalities > 35);
	CHECK(errors > 10);
}

TEST_CASE("the guide lists every function with its meaning") {
	const std::string text = guide();
	for (const Function &function : functions()) {
		for (const Overload *overload : function.overloads) {
			const std::string row = "| `" + overload->signature() + "` | " + in_table(std::string(overload->meaning)) + " |";
			CHECK_MESSAGE(text.find(row) != std::string::npos, row);
		}
	}
}
