#include "playground/document/dependency_graph.hpp"

#include "playground/document/document.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace playground;

namespace {

// The entries of a document, for calling the graph traversals directly.
class Graph {
public:
	Graph(std::initializer_list<std::pair<const char *, const char *>> entries) {
		for (const auto &[name, text] : entries) {
			REQUIRE(_document.add(name, text));
		}
	}

	Entry *operator[](const char *name) { return const_cast<Entry *>(_document.find(name)); }

	std::vector<Entry *> all() {
		std::vector<Entry *> entries;
		entries.reserve(_document.size());
		for (size_t index = 0; index < _document.size(); ++index) {
			entries.push_back(const_cast<Entry *>(&_document.at(index)));
		}
		return entries;
	}

private:
	Document _document;
};

std::string names_of(const std::vector<Component> &components) {
	std::string names;
	for (const Component &component : components) {
		names += names.empty() ? "" : " ";
		for (const Entry *entry : component.members) {
			names += entry->name;
		}
		names += component.is_cycle ? "*" : "";
	}
	return names;
}

} // namespace

TEST_CASE("dependencies come before their dependents") {
	Graph graph{ { "d", "b + c" }, { "b", "a" }, { "c", "a + b" }, { "a", "1" } };
	CHECK(names_of(components_in_evaluation_order(graph.all())) == "a b c d");
	CHECK(names_of(components_in_evaluation_order({ graph["d"], graph["c"] })) == "c d");
	CHECK(with_dependents({ graph["b"] }).size() == 3);
	CHECK(with_dependents({ graph["d"], graph["d"] }).size() == 1);
}

TEST_CASE("cycles are found, and the shortest path around each") {
	Graph graph{ { "a", "b + c" }, { "b", "d" }, { "c", "a" }, { "d", "a" }, { "e", "e + a" }, { "f", "missing" } };
	const std::vector<Component> components = components_in_evaluation_order(graph.all());
	CHECK(names_of(components) == "abdc* e* f");
	std::string path;
	for (const Entry *entry : shortest_cycle(*graph["a"])) {
		path += entry->name;
	}
	CHECK(path == "ac");
	CHECK(shortest_cycle(*graph["e"]).size() == 1);
}
