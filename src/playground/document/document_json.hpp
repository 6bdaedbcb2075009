#pragma once

#include "playground/document/document_state.hpp"

#include <string>
#include <string_view>
#include <vector>

// Documents as text. The format, of which `tests/playground/document/test_document_json.cpp` has an example:
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
// Entries stand in the order of the document; "attributes" may be missing. Keys that are unknown are passed over.

namespace playground {

inline constexpr int DOCUMENT_VERSION = 1;
inline constexpr size_t MAX_DOCUMENT_LENGTH = 16 << 20; // bytes

// One entry a line, so that changes to it are changes of one line.
[[nodiscard]] std::string to_json(const DocumentState &state);

struct LoadedDocument {
	DocumentState state; // of what could be read
	std::vector<std::string> errors; // what could not, and where: "line 7, column 3: entry 'b' skipped: ..."
	bool is_document = false; // whether the text is a document at all, as far as it goes
};

// Reads what it can of any text: an entry that is broken is skipped, and reading goes on behind it. A version that is newer
// is an error, and read as this one.
//
// An array of 32 numbers, as ganja.js writes a multivector, or an array of such arrays is a document, too: entries x1, x2, ..
// with these coefficients.
[[nodiscard]] LoadedDocument read_document(std::string_view text);

} // namespace playground
