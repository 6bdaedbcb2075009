#pragma once

#include "playground/document/document_size.hpp"
#include "playground/document/document_state.hpp"

#include <string>
#include <string_view>
#include <vector>

// Documents as JSON; tests/playground/document/test_document_json.cpp has an example. The format:
//
//   {
//     "format": "ga_godot_scene",
//     "version": 1,
//     "attributes": {"interpolation/mode": "screw"},
//     "entries": [
//       {"name": "a", "expression": "point(1, 2, 3)", "attributes": {"color": "#ff0000", "label": false}},
//       {"name": "b", "expression": "a ^ einf"}
//     ]
//   }
//
// Entries are in the order of the document. "attributes" is optional. Unknown keys are ignored.

namespace playground {

inline constexpr int DOCUMENT_VERSION = 1;

void append_attribute_value(std::string &json, const AttributeValue &value);

// Writes one entry per line, so that a changed entry is a changed line in version control.
[[nodiscard]] std::string to_json(const DocumentState &state);

struct LoadedDocument {
	DocumentState state; // everything that could be read
	std::vector<std::string> errors; // everything that could not: "line 7, column 3: entry 'b' skipped: ..."
	bool is_document = false; // whether the text is a document, even a corrupted one
};

// Reads as much as it can: an invalid entry is skipped, with an error. A newer version is reported as an error
// and read as the current one.
//
// An array of 32 numbers, as ganja.js writes a multivector, or an array of such arrays is a document with entries x1, x2, ...
// with these coefficients.
[[nodiscard]] LoadedDocument read_document(std::string_view text);

} // namespace playground
