// After each random change of a random document, compares every entry with a full evaluation and with a naive recursive
// one: the bits of its value, its error, and whether the change reported its name.

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

using Values = std::map<std::string, EntryValue>;

Values values_of(const Document &document) {
	Values values;
	for (size_t index = 0; index < document.size(); ++index) {
		values.emplace(document.at(index).name, document.at(index).value);
	}
	return values;
}

// The value of each entry, computed recursively; empty if its expression is invalid, or refers to an entry without a value
// or, through others, to the entry itself.
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
		bool is_valid = expression.has_value();
		Variables variables;
		if (is_valid) {
			for (const std::string &dependency : expression->variables()) {
				if (compute(dependency)) {
					variables.emplace(dependency, *values[dependency]);
				} else {
					is_valid = false;
				}
			}
		}
		open.erase(name);
		std::optional<Multivector> value;
		if (is_valid) {
			if (const cga::TextResult<Multivector> result = evaluate(*expression, variables)) {
				value = *result;
			}
		}
		// Within a pending evaluation an empty value may be due to the cycle only, so it is not stored but computed again.
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

std::set<std::string> differences(const Values &before, const Values &after) {
	std::set<std::string> names;
	for (const auto &[name, value] : before) {
		const auto found = after.find(name);
		if (found == after.end() || !is_same(found->second, value)) {
			names.insert(name);
		}
	}
	for (const auto &[name, value] : after) {
		if (before.count(name) == 0) {
			names.insert(name);
		}
	}
	return names;
}

} // namespace

TEST_CASE("incremental evaluation gives the values of full evaluation and reports exactly the changes") {
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
			const Values before = values_of(document);
			const DocumentState state_before = document.state();
			const bool is_undo = step % 17 == 16;
			const ChangeResult change = is_undo ? document.restore(old_state) : random.change(document);
			const Values after = values_of(document);
			CAPTURE(seed);
			CAPTURE(step);
			const std::vector<std::string> names = change ? *change : std::vector<std::string>();
			const std::set<std::string> reported(names.begin(), names.end());
			REQUIRE(reported.size() == names.size());
			if (!change) {
				++refusals;
				REQUIRE(document.state() == state_before);
			}
			REQUIRE(reported == differences(before, after));
			Document fresh;
			REQUIRE(fresh.restore(document.state()));
			const std::map<std::string, std::optional<Multivector>> naive = naive_values(document.state());
			for (const auto &each : after) {
				const std::string &name = each.first;
				const EntryValue &value = each.second;
				CAPTURE(name);
				REQUIRE(naive.at(name) == (value ? std::optional<Multivector>(*value) : std::nullopt));
				REQUIRE((value || !value.error().message.empty()));
				REQUIRE(is_same(fresh.find(name)->value, value));
				values += value ? 1 : 0;
				errors += value ? 0 : 1;
				cycles += !value && value.error().is_cycle ? 1 : 0;
			}
			const LoadedDocument loaded = read_document(to_json(document.state()));
			REQUIRE(loaded.errors.empty());
			REQUIRE(loaded.state == document.state());
			changes += names.empty() ? 0 : 1;
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

TEST_CASE("restoring the state before a change undoes exactly that change") {
	playground_test::RandomDocument random(99);
	Document document;
	for (int step = 0; step < 1000; ++step) {
		const DocumentState state = document.state();
		const Values before = values_of(document);
		const ChangeResult change = random.change(document);
		if (step % 3 == 0) {
			std::vector<std::string> undone = *document.restore(state);
			REQUIRE(document.state() == state);
			REQUIRE(differences(before, values_of(document)).empty());
			std::vector<std::string> reported = change ? *change : std::vector<std::string>();
			std::sort(reported.begin(), reported.end());
			std::sort(undone.begin(), undone.end());
			REQUIRE(reported == undone);
		}
	}
}
