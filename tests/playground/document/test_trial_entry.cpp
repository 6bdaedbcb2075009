#include "random_document.hpp"

#include "playground/document/describe_entry.hpp"

#include <doctest/doctest.h>

using namespace playground;

namespace {

std::string error(const Document &document, const char *name, const char *text) {
	const Entry entry = document.trial_entry(name, text);
	return entry.value ? std::string() : entry.value.error().message;
}

} // namespace

TEST_CASE("a trial entry has the value, the description and the error of its expression") {
	Document document;
	REQUIRE(document.add("a", "2"));
	REQUIRE(document.add("b", "1 / 0"));
	REQUIRE(document.add("c", "b"));
	CHECK(*document.trial_entry("", "a + 1").value == cga::Multivector::scalar(3.0));
	CHECK(describe(document.trial_entry("", "sphere(e1, a)")) == "sphere, radius 2, center (1, 0, 0)");
	CHECK(error(document, "", "a +") == "column 4: expected a number, a name or '(', found the end");
	REQUIRE(document.add("length", "1"));
	CHECK(error(document, "", "a + lenght") == "column 5: there is no entry 'lenght'; did you mean 'length'?");
	CHECK(error(document, "", "a + c") == "column 5: 'c' has an error, caused by 'b'");
	CHECK(document.size() == 4);
}

TEST_CASE("a trial entry has the attributes of the entry with its name") {
	Document document;
	REQUIRE(document.add("p", "e1 ^ e2 ^ einf"));
	REQUIRE(document.set_attribute("p", "ipns", true));
	CHECK(describe(document.trial_entry("p", "e3 ^ einf")) == "dual direction, normal (0, 0, -1)");
	CHECK(describe(document.trial_entry("", "e3 ^ einf")) == "direction, direction (0, 0, 1)");
	CHECK(document.find("p")->text == "e1 ^ e2 ^ einf");
}

TEST_CASE("a trial entry reports the cycle that it would close") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.add("b", "a + 1"));
	REQUIRE(document.add("c", "b + waiting"));
	CHECK(error(document, "a", "a") == "column 1: 'a' refers to itself");
	CHECK(error(document, "a", "2 b") == "column 3: circular dependency a -> b -> a");
	CHECK(error(document, "a", "c * b") == "column 5: circular dependency a -> b -> a");
	CHECK(error(document, "waiting", "c") == "column 1: circular dependency waiting -> c -> waiting");
	CHECK(error(document, "new", "new") == "column 1: 'new' refers to itself");
	CHECK(*document.find("b")->value == cga::Multivector::scalar(2.0));
	CHECK(document.dependents_of("a") == std::vector<std::string>{ "b", "c" });
}

TEST_CASE("a trial entry breaks the cycle that its entry is in") {
	Document document;
	REQUIRE(document.add("a", "b"));
	REQUIRE(document.add("b", "a"));
	CHECK(*document.trial_entry("a", "5").value == cga::Multivector::scalar(5.0));
	CHECK(error(document, "a", "b + 1") == "column 1: circular dependency a -> b -> a");
	CHECK(document.find("a")->value.error().is_cycle);
}

TEST_CASE("a trial entry equals the entry after set_expression, and leaves the document unchanged") {
	int changes = 0;
	int values = 0;
	int cycles = 0;
	for (unsigned seed = 1; seed <= 40; ++seed) {
		playground_test::RandomDocument random(seed);
		Document document;
		for (int step = 0; step < 100; ++step) {
			const bool is_accepted = bool(random.change(document));
			changes += is_accepted ? 1 : 0;
			const DocumentState state = document.state();
			const std::string name = random.name();
			const std::string text = random.expression();
			const Entry trial = document.trial_entry(name, text);
			CAPTURE(seed);
			CAPTURE(step);
			REQUIRE(document.state() == state);
			Document changed;
			REQUIRE(changed.restore(state));
			for (const EntryState &entry : state.entries) {
				REQUIRE(is_same(changed.find(entry.name)->value, document.find(entry.name)->value));
				REQUIRE(changed.dependents_of(entry.name) == document.dependents_of(entry.name));
			}
			if (changed.find(name)) {
				REQUIRE(changed.set_expression(name, text));
			} else if (!changed.add(name, text)) {
				continue; // invalid name
			}
			const Entry &entry = *changed.find(name);
			REQUIRE(is_same(trial.value, entry.value));
			REQUIRE(describe(trial) == describe(entry));
			values += trial.value ? 1 : 0;
			cycles += !trial.value && trial.value.error().is_cycle ? 1 : 0;
		}
	}
	CHECK(changes > 500);
	CHECK(values > 500);
	CHECK(cycles > 100);
}

TEST_CASE("a trial entry at the end of a long chain") {
	Document document;
	REQUIRE(document.add("x0", "1"));
	for (int index = 1; index < 2000; ++index) {
		REQUIRE(document.add("x" + std::to_string(index), "x" + std::to_string(index - 1) + " + 1"));
	}
	CHECK(*document.trial_entry("", "x1999").value == cga::Multivector::scalar(2000.0));
	CHECK(error(document, "x0", "x1999") == "column 1: circular dependency of 2000 entries through 'x1999'");
}
