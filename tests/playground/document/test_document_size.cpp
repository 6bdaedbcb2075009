#include "playground/document/document_size.hpp"

#include "large_documents.hpp"
#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"
#include "random_document.hpp"

#include <doctest/doctest.h>

using namespace playground;
using namespace playground_test;

namespace {

// 1,600,000 bytes that JSON writes as six bytes each.
const std::string CONTROLS(1600000, '\x01');

DocumentSize recomputed(const Document &document) {
	Document copy;
	REQUIRE(copy.restore(document.state()));
	return copy.document_size();
}

} // namespace

TEST_CASE("the size of a document follows every change") {
	RandomDocument random(12);
	Document document;
	for (int step = 0; step < 3000; ++step) {
		(void)random.change(document);
		(void)document.set_document_attribute(random.name(), random.below(3) == 0 ? AttributeValue() : AttributeValue(random.expression()));
		if (step % 10 != 0) {
			continue;
		}
		const DocumentSize size = document.document_size();
		const DocumentSize again = recomputed(document);
		REQUIRE(size.bytes == again.bytes);
		REQUIRE(size.attributes == again.attributes);
		REQUIRE(size.operations == again.operations);
		const size_t written = to_json(document.state()).size();
		REQUIRE(size.bytes >= written);
		REQUIRE(size.bytes <= written + 16 * document.size() + 32);
	}
}

TEST_CASE("a document cannot become longer than can be read") {
	Document document;
	REQUIRE(document.add("a", "1"));
	REQUIRE(document.set_attribute("a", "note", CONTROLS));
	const DocumentState before = document.state();
	const auto is_refused = [&](const ChangeResult &change) {
		REQUIRE(!change);
		CHECK(change.error().message.rfind("the document would be too long: as JSON it would have at least ", 0) == 0);
		CHECK(change.error().message.find(" bytes, and at most 16777216 are accepted") != std::string::npos);
		CHECK(document.state() == before);
	};
	is_refused(document.set_document_attribute("note", AttributeValue(CONTROLS + CONTROLS)));
	is_refused(document.set_attribute("a", "note", CONTROLS + CONTROLS));
	is_refused(document.set_attribute("a", "other", CONTROLS));
	is_refused(document.set_expression("a", CONTROLS));
	is_refused(document.add("b", CONTROLS));
	DocumentState longer = before;
	longer.entries.push_back({ "b", CONTROLS, {} });
	is_refused(document.restore(longer));
	CHECK(document.add("b", "1"));
	const LoadedDocument loaded = read_document(to_json(document.state()));
	CHECK(loaded.errors.empty());
	CHECK(loaded.state == document.state());
	// Renaming can lengthen a text that is too long to be an expression.
	REQUIRE(document.set_attribute("a", "note", AttributeValue()));
	REQUIRE(document.set_expression("b", repeated("a+", 265000)));
	CHECK(document.rename("a", std::string(64, 'c')).error().message.rfind("the document would be too long: ", 0) == 0);
	CHECK(document.find("a") != nullptr);
	REQUIRE(document.remove("b"));
	CHECK(document.rename("a", std::string(64, 'c')));
}

TEST_CASE("a document has a limited number of attributes") {
	Document document;
	REQUIRE(document.add("a", "1"));
	DocumentState state = document.state();
	for (size_t index = 0; index < MAX_ATTRIBUTES; ++index) {
		state.attributes.emplace(name_of(index), 1.0);
	}
	REQUIRE(document.restore(state));
	const std::string message = "the document would have at least 262145 attributes, and at most 262144 are accepted";
	CHECK(document.set_attribute("a", "x", 1.0).error().message == message);
	CHECK(document.set_attribute("a", "visible", true));
	CHECK(document.set_document_attribute("a5", 2.0));
	CHECK(read_document(to_json(document.state())).errors.empty());
	REQUIRE(document.set_document_attribute("a5", AttributeValue()));
	CHECK(document.set_attribute("a", "x", 1.0));
	state.attributes.emplace("y", 1.0);
	CHECK(document.restore(state).error().message == message);
	const LoadedDocument loaded = read_document(attributes_with(MAX_ATTRIBUTES + 5, [](size_t index) { return "\"" + name_of(index) + "\": 1"; }));
	CHECK(!loaded.is_document);
	CHECK(loaded.state == DocumentState());
	REQUIRE(loaded.errors.size() == 1);
	CHECK(loaded.errors[0] == "column 1: the document has too many attributes: at least 262145, and at most 262144 are accepted");
}

TEST_CASE("the expressions of a document have a limited number of operations") {
	const auto operations = [](const std::string &text) {
		Document document;
		REQUIRE(document.add("a", text));
		return document.document_size().operations;
	};
	CHECK(operations("1 + b - 2") == 0);
	CHECK(operations("2 e1 * b ^ c | d << e1 >> e2 & E") == 7);
	CHECK(operations("~!(1 / b)") == 10);
	CHECK(operations("exp(b)") == 12);
	CHECK(operations("meet(b, c) + join(b, c)") == 160);
	CHECK(operations("1 +") == 0);
	Document document;
	DocumentState state;
	for (size_t index = 0; index < MAX_OPERATIONS / 8000; ++index) {
		state.entries.push_back({ name_of(index), repeated("2*", 8000) + "1", {} });
	}
	REQUIRE(document.restore(state));
	const std::string message = "the expressions of the document would take at least 4200000 operations (a product is one, a call 12 or more), and at most 4194304 are accepted";
	CHECK(document.add("b", repeated("2*", 8000) + "1").error().message == message);
	CHECK(document.size() == state.entries.size());
	CHECK(document.add("b", "1"));
	CHECK(document.set_expression("b", repeated("2*", 8000) + "1").error().message == message);
	CHECK(document.find("b")->text == "1");
	REQUIRE(document.remove("a0"));
	CHECK(document.set_expression("b", repeated("2*", 8000) + "1"));
}

TEST_CASE("multivectors beyond the number of entries are reported") {
	std::string one = "[" + repeated("0,", 31) + "0]";
	const LoadedDocument loaded = read_document(list(MAX_ENTRIES + 2, [&one](size_t) -> std::string { return one; }, "[", "]"));
	CHECK(loaded.state.entries.size() == MAX_ENTRIES);
	REQUIRE(loaded.errors.size() == 2);
	CHECK(loaded.errors[0] == "line 65537, column 1: multivector skipped: a document has at most 65536 entries");
}
