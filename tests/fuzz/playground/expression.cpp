// Expressions: parsing, evaluation, renaming of variables, and the parameters of free objects.

#include "valid_document.hpp"

#include "playground/document/parameters.hpp"
#include "playground/document/pasted_text.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/parser.hpp"

namespace {

using fuzz::require;

void parse(const std::string &text) {
	const cga::TextResult<playground::Expression> parsed = playground::parse(text);
	require(parsed || !parsed.error().message.empty(), "neither an expression nor an error", text);
	require(parsed || parsed.error().offset <= text.size(), "the position of an error is not in the text", text);
	const cga::TextResult<cga::Multivector> value = playground::evaluate(text, {});
	require(value ? value->is_finite() : !value.error().message.empty(), "neither a finite value nor an error", text);
}

// Evaluates, edits and renames in a document that defines the names of the corpus.
void edit_document(const std::string &text) {
	playground::Document document;
	require(document.add("a", "point(1, 2, 3)") && document.add("r", "2") && document.add("x", text) && document.add("after", "x + a"), "a valid entry is rejected", text);
	fuzz::require_valid(document, text);
	// A name that the text contains would afterwards refer to the renamed entry, and be renamed back with it.
	std::string unused = "renamed";
	while (text.find(unused) != std::string::npos) {
		unused += '_';
	}
	if (document.rename("a", unused)) {
		require(document.rename(unused, "a").has_value(), "an entry cannot be renamed back", text);
	}
	require(document.find("x")->text == playground::pasted_expression(text), "renaming an entry and back changes the text", text);
	fuzz::require_valid(document, text);
}

void set_parameters(const std::string &text) {
	for (const playground::Parameter &parameter : playground::parameters_of(text)) {
		const auto same = playground::with_parameter(text, parameter.name, parameter.literal.value);
		require(same && *same == text, "setting a parameter to its own value changes the text", text);
		playground::LiteralValue value = parameter.literal.value;
		if (double *number = std::get_if<double>(&value)) {
			*number = *number * 0.7 + 1.0;
		} else if (auto *vector = std::get_if<cga::Vector3<double>>(&value)) {
			*vector = *vector * 0.3 + cga::Vector3<double>(-1.0, 0.0, 1e-5);
		}
		const auto changed = playground::with_parameter(text, parameter.name, value);
		require(changed || !changed.error().message.empty(), "neither a text nor an error", text);
		require(!changed || !playground::parameters_of(*changed).empty(), "after a parameter was set, the text has none", text);
	}
}

} // namespace

void fuzz::run(Input input) {
	const std::string text = input.rest_text();
	// One for each input, as editing a document takes long.
	switch (text.size() % 4) {
		case 0:
			return edit_document(text);
		case 1:
			return set_parameters(text);
		default:
			return parse(text);
	}
}
