// Random documents after random changes, beside what a full evaluation of the same text gives, entry by entry, by the
// meaning of the document alone: values bit for bit, errors, the set of names that a change tells.

#include "random_document.hpp"

#include "playground/document/document_json.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/parser.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

using namespace playground;
using cga::Multivector;

namespace {

using Outcomes = std::map<std::string, Outcome>;

Outcomes outcomes_of(const Document &document) {
	Outcomes outcomes;
	for (size_t index = 0; index < document.size(); ++index) {
		outcomes.emplace(document.at(index).name, document.at(index).outcome);
	}
	return outcomes;
}

// Each entry's value from scratch: none where its text is none, or names what has none, or leads back to it.
std::map<std::string, std::optional<Multivector>> naive_values(const DocumentState &state) {
	std::map<std::string, std::optional<Multivector>> values;
	std::map<std::string, std::string> texts;
	for (const EntryState &entry : state.entries) {
		texts[entry.name] = entry.text;
	}
	std::set<std::string> open;
	const std::function<bool(const std::string &)> compute = [&](const std::string &name) {
		if (values.count(name) > 0) {
			return values[name].has_value();
		}
		const auto found = texts.find(name);
		if (found == texts.end() || !open.insert(name).second) {
			return false;
		}
		const cga::TextResult<Expression> expression = parse(found->second);
		bool is_sound = expression.has_value();
		Variables variables;
		if (is_sound) {
			for (const std::string &dependency : expression->variables()) {
				if (compute(dependency)) {
					variables.emplace(dependency, *values[dependency]);
				} else {
					is_sound = false;
				}
			}
		}
		open.erase(name);
		std::optional<Multivector> value;
		if (is_sound) {
			if (const cga::TextResult<Multivector> result = evaluate(*expression, variables)) {
				value = *result;
			}
		}
		// What was cut short inside of a cycle is not known to be without value elsewhere; computed anew when asked for.
		if (value || open.empty()) {
			values[name] = value;
		}
		return value.has_value();
	};
	for (const EntryState &entry : state.entries) {
		compute(entry.name);
	}
	return values;
}

std::set<std::string> differences(const Outcomes &before, const Outcomes &after) {
	std::set<std::string> names;
	for (const auto &[name, outcome] : before) {
		const auto found = after.find(name);
		const bool is_same = found != after.end() && found->second.error == outcome.error && found->second.is_same_as(outcome);
		if (!is_same) {
			names.insert(name);
		}
	}
	for (const auto &[name, outcome] : after) {
		if (before.count(name) == 0) {
			names.insert(name);
		}
	}
	return names;
}

} // namespace

TEST_CASE("incremental evaluation is full evaluation, and tells exactly what changed") {
	int changes = 0;
	int refusals = 0;
	int values = 0;
	int errors = 0;
	int cycles = 0;
	for (unsigned seed = 1; seed <= 60; ++seed) {
		playground_test::RandomDocument random(seed);
		Document document;
		DocumentState old_state;
		for (int step = 0; step < 100; ++step) {
			const Outcomes before = outcomes_of(document);
			const DocumentState state_before = document.state();
			const bool is_undo = step % 17 == 16;
			const Change change = is_undo ? document.restore(old_state) : random.change(document);
			const Outcomes after = outcomes_of(document);
			CAPTURE(seed);
			CAPTURE(step);
			const std::set<std::string> told(change.names.begin(), change.names.end());
			REQUIRE(told.size() == change.names.size());
			std::set<std::string> expected = differences(before, after);
			if (!change) {
				++refusals;
				REQUIRE(document.state() == state_before);
			}
			REQUIRE(told == expected);
			Document fresh;
			fresh.restore(document.state());
			const std::map<std::string, std::optional<Multivector>> naive = naive_values(document.state());
			for (const auto &[name, outcome] : after) {
				CAPTURE(name);
				REQUIRE(naive.at(name) == outcome.value);
				REQUIRE(outcome.value.has_value() == outcome.error.empty());
				REQUIRE(fresh.find(name)->outcome.error == outcome.error);
				REQUIRE(fresh.find(name)->outcome.is_same_as(outcome));
				values += outcome.value ? 1 : 0;
				errors += outcome.value ? 0 : 1;
				cycles += outcome.is_cycle ? 1 : 0;
			}
			const LoadedDocument loaded = read_document(to_json(document.state()));
			REQUIRE(loaded.errors.empty());
			REQUIRE(loaded.state == document.state());
			changes += change.names.empty() ? 0 : 1;
			if (step % 17 == 3) {
				old_state = document.state();
			}
		}
	}
	MESSAGE(changes, " changes, ", refusals, " refusals, ", values, " values, ", errors, " errors, ", cycles, " of them cycles");
	CHECK(changes > 1000);
	CHECK(refusals > 500);
	CHECK(values > 3000);
	CHECK(errors > 5000);
	CHECK(cycles > 500);
}

TEST_CASE("a change is undone by the state before it, exactly") {
	playground_test::RandomDocument random(99);
	Document document;
	for (int step = 0; step < 1000; ++step) {
		const DocumentState state = document.state();
		const Outcomes before = outcomes_of(document);
		const Change change = random.change(document);
		if (step % 3 == 0) {
			Change undone = document.restore(state);
			REQUIRE(document.state() == state);
			REQUIRE(differences(before, outcomes_of(document)).empty());
			std::vector<std::string> told = change.names;
			std::sort(told.begin(), told.end());
			std::sort(undone.names.begin(), undone.names.end());
			REQUIRE(told == undone.names);
		}
	}
}
