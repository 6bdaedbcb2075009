// Documents as JSON: what can be read of any text is a valid document, which is equal after it was written and read.

#include "valid_document.hpp"

#include "playground/document/document_json.hpp"

void fuzz::run(Input input) {
	const std::string text = input.rest_text();
	const playground::LoadedDocument loaded = playground::read_document(text);
	require(loaded.is_document || !loaded.errors.empty(), "neither a document nor an error", text);
	playground::Document document;
	require(document.restore(loaded.state) && document.state() == loaded.state, "restoring a document changes it", text);
	require_valid(document, text);
	const playground::LoadedDocument again = playground::read_document(playground::to_json(document.state()));
	require(again.errors.empty() && again.state == loaded.state, "a document differs after it was written and read", text);
}
