#include "godot/playground/ga_scene.hpp"

#include "godot/algebra/conversions.hpp"
#include "playground/document/describe_entry.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

// Entries, files, and the registration of the class.

namespace ga_godot {

using godot::Dictionary;
using godot::Error;
using godot::PackedByteArray;
using godot::PackedStringArray;
using godot::Ref;
using godot::String;
using godot::StringName;
using godot::vformat;

static PackedStringArray to_strings(const std::vector<std::string> &texts) {
	PackedStringArray strings;
	strings.resize(int64_t(texts.size()));
	for (size_t i = 0; i < texts.size(); i++) {
		strings.set(int64_t(i), to_godot(texts[i]));
	}
	return strings;
}

static Ref<Multivector> value_of(const playground::Entry &entry) {
	return entry.value ? Multivector::make(*entry.value) : Ref<Multivector>();
}

static String error_of(const playground::Entry &entry) {
	return entry.value ? String() : to_godot(entry.value.error().message);
}

const playground::Entry *GAScene::find(const String &name, const char *method) const {
	const playground::Entry *entry = _document.find(to_utf8(name));
	ERR_FAIL_NULL_V_MSG(entry, nullptr, vformat("GAScene.%s: there is no entry \"%s\"; get_names() lists the entries.", method, to_godot(cga::shortened(to_utf8(name)))));
	return entry;
}

Error GAScene::finish(const playground::ChangeResult &change, const char *method) {
	ERR_FAIL_COND_V_MSG(!change, godot::ERR_INVALID_PARAMETER, vformat("GAScene.%s: %s.", method, to_godot(change.error().message)));
	const Ref<GAScene> self(this); // A handler may release the last reference.
	if (!change->empty()) {
		emit_signal("entries_changed", to_strings(*change));
	}
	emit_changed();
	return godot::OK;
}

Error GAScene::add_entry(const String &name, const String &expression, int64_t index) {
	const int64_t count = int64_t(_document.size());
	ERR_FAIL_COND_V_MSG(index < -1 || index > count, godot::ERR_INVALID_PARAMETER, vformat("GAScene.add_entry: the index must be in 0..%d, or -1 to append, not %d.", count, index));
	return finish(_document.add(to_utf8(name), to_utf8(expression), size_t(index < 0 ? count : index)), "add_entry");
}

Error GAScene::set_expression(const String &name, const String &expression) {
	return finish(_document.set_expression(to_utf8(name), to_utf8(expression)), "set_expression");
}

Error GAScene::rename_entry(const String &from, const String &to) {
	return finish(_document.rename(to_utf8(from), to_utf8(to)), "rename_entry");
}

Error GAScene::remove_entry(const String &name) {
	return finish(_document.remove(to_utf8(name)), "remove_entry");
}

Error GAScene::move_entry(const String &name, int64_t index) {
	ERR_FAIL_COND_V_MSG(index < 0, godot::ERR_INVALID_PARAMETER, vformat("GAScene.move_entry: the index must be at least 0, not %d.", index));
	return finish(_document.move(to_utf8(name), size_t(index)), "move_entry");
}

int64_t GAScene::get_entry_count() const {
	return int64_t(_document.size());
}

bool GAScene::has_entry(const String &name) const {
	return _document.find(to_utf8(name)) != nullptr;
}

int64_t GAScene::get_index(const String &name) const {
	const size_t index = _document.index_of(to_utf8(name));
	return index < _document.size() ? int64_t(index) : -1;
}

PackedStringArray GAScene::get_names() const {
	PackedStringArray names;
	names.resize(int64_t(_document.size()));
	for (size_t i = 0; i < _document.size(); i++) {
		names.set(int64_t(i), to_godot(_document.at(i).name));
	}
	return names;
}

String GAScene::get_expression(const String &name) const {
	const playground::Entry *entry = find(name, "get_expression");
	return entry ? to_godot(entry->text) : String();
}

Ref<Multivector> GAScene::get_value(const String &name) const {
	const playground::Entry *entry = find(name, "get_value");
	return entry ? value_of(*entry) : Ref<Multivector>();
}

String GAScene::get_error(const String &name) const {
	const playground::Entry *entry = find(name, "get_error");
	return entry ? error_of(*entry) : String();
}

String GAScene::get_description(const String &name) const {
	const playground::Entry *entry = find(name, "get_description");
	return entry ? to_godot(playground::describe(*entry)) : String();
}

PackedStringArray GAScene::get_dependencies(const String &name) const {
	const playground::Entry *entry = find(name, "get_dependencies");
	return entry && entry->expression ? to_strings(entry->expression->variables()) : PackedStringArray();
}

PackedStringArray GAScene::get_dependents(const String &name) const {
	const playground::Entry *entry = find(name, "get_dependents");
	return entry ? to_strings(_document.dependents_of(entry->name)) : PackedStringArray();
}

Ref<Multivector> GAScene::evaluate(const String &expression) const {
	const cga::TextResult<cga::Multivector> value = _document.evaluate(to_utf8(expression));
	ERR_FAIL_COND_V_MSG(!value, Ref<Multivector>(), vformat("GAScene.evaluate: %s.", to_godot(value.error().describe())));
	return Multivector::make(*value);
}

Dictionary GAScene::describe_expression(const String &text, const StringName &as_entry) const {
	const playground::Entry entry = _document.trial_entry(to_utf8(as_entry), to_utf8(text));
	Dictionary result;
	result["value"] = entry.value ? godot::Variant(value_of(entry)) : godot::Variant();
	result["description"] = entry.value ? to_godot(playground::describe(entry)) : String();
	result["error"] = error_of(entry);
	return result;
}

String GAScene::get_name_error(const String &name) const {
	const cga::Result<void, playground::Error> checked = _document.check_new_name(to_utf8(name));
	return checked ? String() : to_godot(checked.error().message);
}

String GAScene::to_json() const {
	return to_godot(playground::to_json(_document.state()));
}

Error GAScene::load(const String &text, const char *member) {
	playground::LoadedDocument loaded;
	if (text.length() > int64_t(playground::MAX_DOCUMENT_LENGTH)) {
		// Before the conversion to UTF-8, which would take time.
		loaded.errors = { "the document is too long: it has " + std::to_string(text.length()) + " characters, and at most " + std::to_string(playground::MAX_DOCUMENT_LENGTH) + " bytes are accepted" };
	} else {
		loaded = playground::read_document(to_utf8(text));
	}
	return load(std::move(loaded), member);
}

Error GAScene::load(playground::LoadedDocument loaded, const char *member) {
	const Ref<GAScene> self(this); // A handler of a signal may release the last reference, or load another document.
	_load_errors = loaded.errors;
	if (loaded.is_document) {
		const playground::ChangeResult change = _document.restore(std::move(loaded.state));
		if (change) {
			finish(change, member);
		} else {
			loaded.errors = _load_errors = { change.error().message };
			loaded.is_document = false;
		}
	}
	if (loaded.errors.empty()) {
		return godot::OK;
	}
	std::string places;
	for (const std::string &error : loaded.errors) {
		places += "\n" + error + ".";
	}
	const char *outcome = loaded.is_document ? "parts of the text could not be read; the rest was loaded" : "the text was not loaded; the scene is unchanged";
	ERR_FAIL_V_MSG(loaded.is_document ? godot::ERR_FILE_CORRUPT : godot::ERR_PARSE_ERROR, vformat("GAScene.%s: %s:%s", member, outcome, to_godot(places)));
}

Error GAScene::load_json(const String &text) {
	return load(text, "load_json");
}

Error GAScene::load_json_utf8(const PackedByteArray &bytes) {
	constexpr std::string_view BYTE_ORDER_MARK = "\xef\xbb\xbf";
	std::string_view text(reinterpret_cast<const char *>(bytes.ptr()), size_t(bytes.size()));
	if (text.substr(0, BYTE_ORDER_MARK.size()) == BYTE_ORDER_MARK) {
		text.remove_prefix(BYTE_ORDER_MARK.size());
	}
	return load(playground::read_document(text), "load_json_utf8");
}

PackedStringArray GAScene::get_load_errors() const {
	return to_strings(_load_errors);
}

void GAScene::set_document(const String &text) {
	if (text.is_empty()) {
		_load_errors.clear();
		finish(_document.restore({}), "document");
		return;
	}
	load(text, "document");
}

String GAScene::get_document() const {
	return _document.size() == 0 && _document.attributes().empty() ? String() : to_json();
}

void GAScene::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("add_entry", "name", "expression", "index"), guarded<&GAScene::add_entry>(), DEFVAL(-1));
	ClassDB::bind_method(D_METHOD("set_expression", "name", "expression"), guarded<&GAScene::set_expression>());
	ClassDB::bind_method(D_METHOD("rename_entry", "from", "to"), guarded<&GAScene::rename_entry>());
	ClassDB::bind_method(D_METHOD("remove_entry", "name"), guarded<&GAScene::remove_entry>());
	ClassDB::bind_method(D_METHOD("move_entry", "name", "index"), guarded<&GAScene::move_entry>());

	ClassDB::bind_method(D_METHOD("get_entry_count"), guarded<&GAScene::get_entry_count>());
	ClassDB::bind_method(D_METHOD("has_entry", "name"), guarded<&GAScene::has_entry>());
	ClassDB::bind_method(D_METHOD("get_index", "name"), guarded<&GAScene::get_index>());
	ClassDB::bind_method(D_METHOD("get_names"), guarded<&GAScene::get_names>());
	ClassDB::bind_method(D_METHOD("get_expression", "name"), guarded<&GAScene::get_expression>());
	ClassDB::bind_method(D_METHOD("get_value", "name"), guarded<&GAScene::get_value>());
	ClassDB::bind_method(D_METHOD("get_error", "name"), guarded<&GAScene::get_error>());
	ClassDB::bind_method(D_METHOD("get_description", "name"), guarded<&GAScene::get_description>());
	ClassDB::bind_method(D_METHOD("get_dependencies", "name"), guarded<&GAScene::get_dependencies>());
	ClassDB::bind_method(D_METHOD("get_dependents", "name"), guarded<&GAScene::get_dependents>());
	ClassDB::bind_method(D_METHOD("evaluate", "expression"), guarded<&GAScene::evaluate>());
	ClassDB::bind_method(D_METHOD("describe_expression", "text", "as_entry"), guarded<&GAScene::describe_expression>(), DEFVAL(StringName()));
	ClassDB::bind_method(D_METHOD("get_name_error", "name"), guarded<&GAScene::get_name_error>());

	ClassDB::bind_method(D_METHOD("get_parameters", "name"), guarded<&GAScene::get_parameters>());
	ClassDB::bind_method(D_METHOD("set_parameter", "name", "key", "value"), guarded<&GAScene::set_parameter>());

	ClassDB::bind_method(D_METHOD("get_handles", "name", "right"), guarded<&GAScene::get_handles>(), DEFVAL(godot::Vector3(1, 0, 0)));
	ClassDB::bind_method(D_METHOD("drag_handle", "name", "handle", "ray_origin", "ray_direction", "view", "step", "angle_step"), guarded<&GAScene::drag_handle>(), DEFVAL(0.0), DEFVAL(0.0));

	ClassDB::bind_method(D_METHOD("set_entry_attribute", "name", "key", "value"), guarded<&GAScene::set_entry_attribute>());
	ClassDB::bind_method(D_METHOD("get_entry_attribute", "name", "key"), guarded<&GAScene::get_entry_attribute>());
	ClassDB::bind_method(D_METHOD("get_entry_attributes", "name"), guarded<&GAScene::get_entry_attributes>());
	ClassDB::bind_method(D_METHOD("set_scene_attribute", "key", "value"), guarded<&GAScene::set_scene_attribute>());
	ClassDB::bind_method(D_METHOD("get_scene_attribute", "key"), guarded<&GAScene::get_scene_attribute>());
	ClassDB::bind_method(D_METHOD("get_scene_attributes"), guarded<&GAScene::get_scene_attributes>());

	ClassDB::bind_method(D_METHOD("to_json"), guarded<&GAScene::to_json>());
	ClassDB::bind_method(D_METHOD("load_json", "text"), guarded<&GAScene::load_json>());
	ClassDB::bind_method(D_METHOD("load_json_utf8", "bytes"), guarded<&GAScene::load_json_utf8>());
	ClassDB::bind_method(D_METHOD("get_load_errors"), guarded<&GAScene::get_load_errors>());

	ClassDB::bind_method(D_METHOD("set_document", "text"), guarded<&GAScene::set_document>());
	ClassDB::bind_method(D_METHOD("get_document"), guarded<&GAScene::get_document>());
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "document", godot::PROPERTY_HINT_NONE, "", godot::PROPERTY_USAGE_STORAGE), "set_document", "get_document");

	ADD_SIGNAL(godot::MethodInfo("entries_changed", PropertyInfo(Variant::PACKED_STRING_ARRAY, "names")));
}

} // namespace ga_godot
