#include "playground/document/document.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace playground;
using Names = std::vector<std::string>;

namespace {

double number(const Document &document, const char *name) {
	const Entry *entry = document.find(name);
	REQUIRE_MESSAGE(entry->value, name, ": ", entry->value.error().message);
	return (*entry->value)[0];
}

std::string error(const Document &document, const char *name) {
	const EntryValue &value = document.find(name)->value;
	return value ? std::string() : value.error().message;
}

// The names of a change, in order.
std::string changed_names(const ChangeResult &change) {
	REQUIRE_MESSAGE(change, change.error().message);
	std::string names;
	for (const std::string &name : *change) {
		names += (names.empty() ? "" : " ") + name;
	}
	return names;
}

Names names_of(const Document &document) {
	Names names;
	for (size_t index = 0; index < document.size(); ++index) {
		names.push_back(document.at(index).name);
	}
	return names;
}

} // namespace

TEST_CASE("an entry may refer to earlier and to later entries") {
	Document document;
	CHECK(changed_names(document.add("c", "a + b")) == "c");
	CHECK(changed_names(document.add("a", "1")) == "a c");
	CHECK(error(document, "c") == "column 5: there is no entry 'b'");
	CHECK(changed_names(document.add("b", "a + 1")) == "b c");
	CHECK(number(document, "c") == 3.0);
	CHECK(changed_names(document.set_expression("a", "10")) == "a b c");
	CHECK(number(document, "c") == 21.0);
	CHECK(document.dependents_of("a") == Names{ "c", "b" });
	CHECK(document.dependents_of("c").empty());
	CHECK(document.dependents_of("nobody").empty());
}

TEST_CASE("unchanged entries are neither recomputed nor reported") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.add("b", "floor(a)"));
	REQUIRE(document.add("c", "b + 1"));
	REQUIRE(document.add("d", "a * 2"));
	CHECK(changed_names(document.set_expression("a", "1.5")) == "a d");
	CHECK(document.set_expression("a", "3 / 2")->empty());
	CHECK(document.set_expression("a", "3 / 2")->empty());
	// 0 and -0 are equal, but atan2 distinguishes them, so the change must propagate.
	REQUIRE(document.set_expression("a", "0"));
	REQUIRE(document.add("e", "atan2(a, -1)"));
	CHECK(changed_names(document.set_expression("a", "-1 * 0")) == "a b d e");
	CHECK(number(document, "e") < 0.0);
}

TEST_CASE("an error in one entry leaves the others unaffected, and its dependents name the cause") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.add("b", "2 / a"));
	REQUIRE(document.add("c", "b * 2"));
	REQUIRE(document.add("d", "5 + c"));
	REQUIRE(document.add("other", "7"));
	CHECK(changed_names(document.set_expression("a", "0")) == "a b c d");
	CHECK(error(document, "b") == "column 3: division by zero");
	CHECK(error(document, "c") == "column 1: 'b' has an error");
	CHECK(error(document, "d") == "column 5: 'c' has an error, caused by 'b'");
	CHECK(number(document, "other") == 7.0);
	CHECK(changed_names(document.set_expression("a", "1 +")) == "a b c d");
	CHECK(error(document, "a") == "column 4: expected a number, a name or '(', found the end");
	CHECK(error(document, "d") == "column 5: 'c' has an error, caused by 'a'");
	CHECK(changed_names(document.set_expression("a", "2")) == "a b c d");
	CHECK(number(document, "d") == 7.0);
}

TEST_CASE("the error for a missing entry suggests a similar name") {
	Document document;
	REQUIRE(document.add("sum", "2 + radius_1"));
	CHECK(error(document, "sum") == "column 5: there is no entry 'radius_1'");
	CHECK(changed_names(document.add("radius1", "1")) == "radius1 sum");
	CHECK(error(document, "sum") == "column 5: there is no entry 'radius_1'; did you mean 'radius1'?");
	REQUIRE(document.add("f", "sqrt + 1"));
	CHECK(error(document, "f") == "column 1: there is no entry 'sqrt'; to call the function write 'sqrt('");
}

TEST_CASE("a cycle is an error of its members only; their dependents report them") {
	Document document;
	REQUIRE(document.add("a", "a + 1"));
	CHECK(error(document, "a") == "column 1: 'a' refers to itself");
	REQUIRE(document.set_expression("a", "c"));
	REQUIRE(document.add("b", "1 + a"));
	REQUIRE(document.add("c", "2 * b"));
	REQUIRE(document.add("after", "c"));
	REQUIRE(document.add("before", "3"));
	CHECK(error(document, "a") == "column 1: circular dependency a -> c -> b -> a");
	CHECK(error(document, "b") == "column 5: circular dependency b -> a -> c -> b");
	CHECK(error(document, "after") == "column 1: 'c' has an error");
	CHECK(number(document, "before") == 3.0);
	CHECK(changed_names(document.set_expression("b", "before")) == "b c a after");
	CHECK(number(document, "a") == 6.0);
}

TEST_CASE("an entry that leaves a cycle is no longer a member of it") {
	Document document;
	REQUIRE(document.add("a", "b + x"));
	REQUIRE(document.add("b", "a"));
	REQUIRE(document.add("x", "a"));
	const std::string before = error(document, "a");
	REQUIRE(document.set_expression("a", "b"));
	CHECK(error(document, "a") == before);
	CHECK(error(document, "x") == "column 1: 'a' has an error");
}

TEST_CASE("long cycles and long chains") {
	Document document;
	constexpr int COUNT = 5000;
	DocumentState state;
	for (int index = 0; index < COUNT; ++index) {
		state.entries.push_back({ "x" + std::to_string(index), "1 + x" + std::to_string(index + 1), {} });
	}
	CHECK(document.restore(state)->size() == COUNT);
	CHECK(error(document, "x0") == "column 5: 'x1' has an error, caused by 'x4999'");
	CHECK(document.add("x5000", "0")->size() == COUNT + 1);
	CHECK(number(document, "x0") == COUNT);
	REQUIRE(document.set_expression("x5000", "x0"));
	CHECK(error(document, "x7") == "column 5: circular dependency of 5001 entries through 'x8'");
	REQUIRE(document.set_expression("x5000", "1"));
	CHECK(number(document, "x0") == COUNT + 1);
}

TEST_CASE("renaming an entry rewrites the references to it and nothing else") {
	Document document;
	REQUIRE(document.add("p", "point(1, 2, 3)"));
	REQUIRE(document.add("point", "2"));
	REQUIRE(document.add("q", "  p ^(p  + point(0,0,0))*pp "));
	REQUIRE(document.add("pp", "1"));
	REQUIRE(document.add("broken", "p + p( - p ∧ p"));
	CHECK(changed_names(document.rename("p", "größe")) == "p größe broken");
	CHECK(document.find("q")->text == "  größe ^(größe  + point(0,0,0))*pp ");
	CHECK(document.find("broken")->text == "größe + p( - größe ∧ p");
	CHECK(changed_names(document.rename("point", "number")) == "point number");
	CHECK(document.find("q")->text == "  größe ^(größe  + point(0,0,0))*pp ");
	CHECK(document.find("q")->value.has_value());
	CHECK(document.rename("pp", "pp")->empty());
	CHECK(document.rename("pp", "q").error().message == "an entry 'q' already exists");
	CHECK(document.rename("pp", "e1").error().message == "'e1' is a constant; choose another name");
	CHECK(document.rename("nobody", "x").error().message == "there is no entry 'nobody'");
	CHECK(names_of(document) == Names{ "größe", "number", "q", "pp", "broken" });
}

TEST_CASE("renaming an entry to a name that other entries already refer to") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.add("b", "x + 1"));
	REQUIRE(document.add("c", "a + 1"));
	const Names changed = *document.rename("a", "x");
	CHECK(changed == Names{ "a", "x", "b" });
	CHECK(number(document, "b") == 2.0);
	CHECK(document.find("c")->text == "x + 1");
}

TEST_CASE("renaming within cycles and errors") {
	Document document;
	REQUIRE(document.add("a", "b"));
	REQUIRE(document.add("b", "a"));
	REQUIRE(document.add("c", "b"));
	REQUIRE(document.rename("a", "z"));
	CHECK(error(document, "z") == "column 1: circular dependency z -> b -> z");
	CHECK(error(document, "b") == "column 1: circular dependency b -> z -> b");
	REQUIRE(document.rename("b", "y"));
	CHECK(error(document, "c") == "column 1: 'y' has an error");
}

TEST_CASE("rename() refuses a name that would make an expression too long") {
	Document document;
	REQUIRE(document.add("a", "1"));
	std::string text = "a";
	while (text.size() < 16000) {
		text += "+a";
	}
	REQUIRE(document.add("b", text));
	CHECK(document.rename("a", "a_long_name").error().message == "the expression of 'b' would become longer than 16384 bytes; choose a shorter name");
	CHECK(document.find("a") != nullptr);
}

TEST_CASE("after an entry is removed, its dependents name it as missing") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.add("b", "a + a"));
	REQUIRE(document.add("c", "b"));
	CHECK(changed_names(document.remove("a")) == "a b c");
	CHECK(error(document, "b") == "column 1: there is no entry 'a'");
	CHECK(error(document, "c") == "column 1: 'b' has an error");
	CHECK(changed_names(document.add("a", "4", 0)) == "a b c");
	CHECK(number(document, "c") == 8.0);
	CHECK(names_of(document) == Names{ "a", "b", "c" });
	CHECK(document.remove("nobody").error().message == "there is no entry 'nobody'");
}

TEST_CASE("moving an entry changes only the order") {
	Document document;
	for (const char *name : { "a", "b", "c", "d" }) {
		REQUIRE(document.add(name, "1"));
	}
	CHECK(document.move("a", 2)->empty());
	CHECK(names_of(document) == Names{ "b", "c", "a", "d" });
	REQUIRE(document.move("d", 0));
	CHECK(names_of(document) == Names{ "d", "b", "c", "a" });
	REQUIRE(document.move("c", 2));
	CHECK(names_of(document) == Names{ "d", "b", "c", "a" });
	CHECK(document.move("c", 4).error().message == "the index 4 is outside 0..3");
	CHECK(document.move("x", 0).error().message == "there is no entry 'x'");
	CHECK(document.index_of("c") == 2);
	CHECK(document.index_of("x") == 4);
}

TEST_CASE("restoring a state restores entries, values and attributes") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.add("b", "a + 1"));
	REQUIRE(document.set_attribute("b", "note", std::string("hello")));
	const DocumentState before = document.state();
	REQUIRE(document.remove("a"));
	REQUIRE(document.rename("b", "c"));
	REQUIRE(document.add("d", "c"));
	REQUIRE(document.set_document_attribute("title", std::string("x")));
	Names changed = *document.restore(before);
	std::sort(changed.begin(), changed.end());
	CHECK(changed == Names{ "a", "b", "c", "d" });
	CHECK(document.state() == before);
	CHECK(number(document, "b") == 2.0);
	CHECK(document.restore(before)->empty());
}

TEST_CASE("entries with invalid or duplicate names are not restored") {
	Document document;
	CHECK(changed_names(document.restore({ { { "a", "1", {} }, { "a", "2", {} }, { "e1", "3", {} }, { "", "3", {} } }, {} })) == "a");
	CHECK(number(document, "a") == 1.0);
}

TEST_CASE("an expression may refer to entries without becoming one") {
	Document document;
	REQUIRE(document.add("a", "2"));
	REQUIRE(document.add("b", "1 / 0"));
	CHECK((*document.evaluate("a + 1"))[0] == 3.0);
	CHECK(document.evaluate("1 + bb").error().describe() == "column 5: there is no entry 'bb'");
	CHECK(document.evaluate("1 + b").error().describe() == "column 5: 'b' has an error; column 3: division by zero");
	CHECK(document.evaluate("1 +").error().describe() == "column 4: expected a number, a name or '(', found the end");
	CHECK(document.size() == 2);
}

TEST_CASE("coefficients in the format of ganja.js can be pasted") {
	Document document;
	std::string array = "[0, -1.5";
	std::string object = "{\"0\":0,\"1\":-1.5";
	for (int index = 2; index < 32; ++index) {
		array += ", 1e21";
		object += ",\"" + std::to_string(index) + "\":1e21";
	}
	REQUIRE(document.add("a", array + "]"));
	REQUIRE(document.add("b", object + "}"));
	CHECK((*document.find("a")->value)[31] == 1e21);
	CHECK(is_same(document.find("a")->value, document.find("b")->value));
	REQUIRE(document.set_expression("b", "-" + array + "] ^ e1"));
	CHECK(document.find("b")->value.has_value());
	REQUIRE(document.set_expression("b", "1 + [1, 2, x]"));
	CHECK(error(document, "b") == "column 12: expected a number, found 'x'");
	REQUIRE(document.set_expression("b", "{}"));
	CHECK(error(document, "b") == "column 1: '{' is not part of the language; write '(' and ')'");
}

TEST_CASE("set_parameter changes a literal or is refused") {
	Document document;
	REQUIRE(document.add("s", "sphere(e1, r)"));
	REQUIRE(document.add("r", "2"));
	REQUIRE(document.add("m", "meet(s, plane(e3, 0))"));
	CHECK(changed_names(document.set_parameter("s", "center", cga::Vector3<double>(1.0, 2.0, 0.0))) == "s m");
	CHECK(document.find("s")->text == "sphere(e1 + 2 e2, r)");
	CHECK(document.set_parameter("s", "radius", 3.0).error().message == "the expression has no parameter 'radius'; it has center");
	CHECK(changed_names(document.set_parameter("r", "value", 3.0)) == "r s m");
	REQUIRE(document.add("t", "sphere(0, 1)"));
	CHECK(document.set_parameter("t", "radius", -1.0).error().message == "sphere: the radius must be a finite number above zero");
	CHECK(document.find("t")->text == "sphere(0, 1)");
	CHECK(document.set_parameter("x", "radius", 1.0).error().message == "there is no entry 'x'");
}
