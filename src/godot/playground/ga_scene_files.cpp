#include "godot/algebra/conversions.hpp"
#include "godot/playground/ga_scene.hpp"
#include "playground/document/document_json.hpp"

#include <godot_cpp/core/error_macros.hpp>

// Scenes as text: what is saved, and read again as far as it can be.

namespace ga_godot {

using godot::Error;
using godot::String;
using godot::vformat;

String GAScene::to_json() const {
	return to_godot(playground::to_json(_document.state()));
}

Error GAScene::load(const String &p_text, const char *p_what) {
	playground::LoadedDocument loaded = playground::read_document(to_utf8(p_text));
	_load_errors = std::move(loaded.errors);
	if (loaded.is_document) {
		finish(_document.restore(loaded.state), p_what);
	}
	if (_load_errors.empty()) {
		return godot::OK;
	}
	std::string places;
	for (const std::string &error : _load_errors) {
		places += "\n" + error + ".";
	}
	const char *outcome = loaded.is_document ? "a part of the text cannot be read; the rest is loaded" : "the text is no document; the scene stays as it was";
	ERR_FAIL_V_MSG(loaded.is_document ? godot::ERR_FILE_CORRUPT : godot::ERR_PARSE_ERROR, vformat("GAScene.%s: %s:%s", p_what, outcome, to_godot(places)));
}

Error GAScene::load_json(const String &p_text) {
	return load(p_text, "load_json");
}

void GAScene::set_document(const String &p_text) {
	if (p_text.is_empty()) {
		_load_errors.clear();
		finish(_document.restore({}), "document");
		return;
	}
	load(p_text, "document");
}

String GAScene::get_document() const {
	return _document.size() == 0 && _document.attributes().empty() ? String() : to_json();
}

} // namespace ga_godot
