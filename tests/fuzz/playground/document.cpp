// Sequences of edits of a document. After them, all values are those of a document that is evaluated as a whole; a
// refused edit changes nothing; the state before an edit can be restored.

#include "valid_document.hpp"

#include "cga/text/utf8.hpp"
#include "playground/document/document_json.hpp"
#include "playground/document/parameters.hpp"

namespace {

using fuzz::Input;
using fuzz::require;

constexpr size_t MAX_ENTRIES = 24;
constexpr const char *NAMES[] = { "a", "b", "c", "d", "r", "x1", "\xc3\xa4", "sphere", "e1", "", "2x", "a b" };
constexpr const char *EXPRESSIONS[] = {
	"point(1, 2, 3)",
	"sphere(a, 2)",
	"a",
	"b ^ c",
	"a + b",
	"r * d",
	"c",
	"sphere(e1, r)",
	"meet(a, b)",
	"1 / r",
	"motor(e1, rotor(e3, deg(90)), 1)",
	"2",
	"-0.5",
	"exp(a)",
	"a + a + d",
	"x1 * x1",
	"circle(e1, e3, r)",
	"[1",
	"line(a, b)",
	"plane(0, 0, 1, r)",
	"1 + 2 e12",
	"dual(",
	"\xc3\xa4 + 1",
	"",
};
constexpr const char *KEYS[] = { "visible", "label", "ipns", "color", "note", "tool/step", "", "b\xff" };

// Valid UTF-8, as all text from the engine is: other bytes would not be the same after writing and reading.
std::string text_from(Input &input) {
	const std::string text = input.text();
	std::string valid;
	for (size_t at = 0; at < text.size();) {
		const cga::Character character = cga::character_at(text, at);
		valid += character.is_valid ? text.substr(at, character.length) : "?";
		at += character.length;
	}
	return valid;
}

std::string name_from(Input &input) {
	const uint8_t choice = input.byte();
	return choice < 240 ? NAMES[choice % std::size(NAMES)] : text_from(input);
}

std::string expression_from(Input &input) {
	const uint8_t choice = input.byte();
	return choice < 200 ? EXPRESSIONS[choice % std::size(EXPRESSIONS)] : text_from(input);
}

playground::AttributeValue attribute_from(Input &input) {
	switch (input.byte() % 4) {
		case 0:
			return std::monostate();
		case 1:
			return input.flag();
		case 2:
			return input.number();
		default:
			return input.flag() ? "#ff0080" : text_from(input);
	}
}

playground::LiteralValue literal_from(Input &input) {
	switch (input.byte() % 4) {
		case 0:
			return input.number();
		case 1:
			return cga::Vector3<double>(input.number(), input.number(), input.number());
		case 2:
			return cga::Quaternion<double>(input.number(), input.number(), input.number(), input.number());
		default:
			return cga::Multivector::basis_blade(int(input.byte() % 32), input.number());
	}
}

playground::ChangeResult change(playground::Document &document, Input &input) {
	const std::string name = name_from(input);
	switch (input.byte() % 9) {
		case 0:
		case 1:
			if (document.size() < MAX_ENTRIES) {
				return document.add(name, expression_from(input), input.byte());
			}
			return document.remove(name);
		case 2:
		case 3:
			return document.set_expression(name, expression_from(input));
		case 4:
			return document.rename(name, name_from(input));
		case 5:
			return document.remove(name);
		case 6:
			return document.move(name, input.byte());
		case 7: {
			const playground::Entry *entry = document.find(name);
			const std::vector<playground::Parameter> parameters = playground::parameters_of(entry != nullptr ? entry->text : std::string());
			const std::string parameter = parameters.empty() ? text_from(input) : parameters[input.byte() % parameters.size()].name;
			return document.set_parameter(name, parameter, literal_from(input));
		}
		default: {
			const std::string key = KEYS[input.byte() % std::size(KEYS)];
			return input.flag() ? document.set_attribute(name, key, attribute_from(input)) : document.set_document_attribute(key, attribute_from(input));
		}
	}
}

// Requires that its values are those of a document that is evaluated as a whole.
void require_whole(const playground::Document &document) {
	playground::Document whole;
	require(whole.restore(document.state()) && whole.state() == document.state(), "the state of a document cannot be restored");
	for (size_t i = 0; i < document.size(); ++i) {
		require(is_same(document.at(i).value, whole.at(i).value), "the values of an entry differ", document.at(i).name + ": " + document.at(i).text);
	}
	fuzz::require_valid(document, "");
}

} // namespace

void fuzz::run(Input input) {
	playground::Document document;
	for (int edits = 0; !input.is_empty() && edits < 32; ++edits) {
		const playground::DocumentState before = document.state();
		const playground::ChangeResult result = change(document, input);
		require(result || !result.error().message.empty(), "an error has no message");
		require(result || document.state() == before, "a refused edit changes the document");
		const uint8_t then = input.byte();
		if (then >= 240) {
			require(document.restore(before) && document.state() == before, "an edit cannot be undone");
		} else if (then >= 160) {
			require_whole(document);
		}
	}
	require_whole(document);
	const playground::LoadedDocument loaded = playground::read_document(playground::to_json(document.state()));
	require(loaded.errors.empty() && loaded.state == document.state(), "a document differs after it was written and read");
	for (const char *name : NAMES) {
		(void)document.dependents_of(name);
		(void)document.trial_entry(name, "a + b");
	}
}
