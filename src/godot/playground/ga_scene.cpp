#include "godot/playground/ga_scene.hpp"

#include "godot/algebra/conversions.hpp"
#include "playground/document/describe_entry.hpp"

#include <godot_cpp/core/error_macros.hpp>

// Entries: changed, read and computed with.

namespace ga_godot {

using godot::Error;
using godot::PackedStringArray;
using godot::Ref;
using godot::String;
using godot::vformat;

static PackedStringArray to_strings(const std::vector<std::string> &p_texts) {
	PackedStringArray strings;
	strings.resize(int64_t(p_texts.size()));
	for (size_t i = 0; i < p_texts.size(); i++) {
		strings.set(int64_t(i), to_godot(p_texts[i]));
	}
	return strings;
}

const playground::Entry *GAScene::find(const String &p_name, const char *p_method) const {
	const playground::Entry *entry = _document.find(to_utf8(p_name));
	ERR_FAIL_NULL_V_MSG(entry, nullptr, vformat("GAScene.%s: there is no entry \"%s\"; get_names() lists those there are.", p_method, p_name));
	return entry;
}

Error GAScene::finish(const playground::ChangeResult &p_change, const char *p_method) {
	ERR_FAIL_COND_V_MSG(!p_change, godot::ERR_INVALID_PARAMETER, vformat("GAScene.%s: %s.", p_method, to_godot(p_change.error().message)));
	if (!p_change->empty()) {
		emit_signal("entries_changed", to_strings(*p_change));
	}
	emit_changed();
	return godot::OK;
}

Error GAScene::add_entry(const String &p_name, const String &p_expression, int64_t p_index) {
	const int64_t count = int64_t(_document.size());
	ERR_FAIL_COND_V_MSG(p_index < -1 || p_index > count, godot::ERR_INVALID_PARAMETER, vformat("GAScene.add_entry: the index %d is not in 0..%d, nor -1 for the end.", p_index, count));
	return finish(_document.add(to_utf8(p_name), to_utf8(p_expression), size_t(p_index < 0 ? count : p_index)), "add_entry");
}

Error GAScene::set_expression(const String &p_name, const String &p_expression) {
	return finish(_document.set_expression(to_utf8(p_name), to_utf8(p_expression)), "set_expression");
}

Error GAScene::rename_entry(const String &p_from, const String &p_to) {
	return finish(_document.rename(to_utf8(p_from), to_utf8(p_to)), "rename_entry");
}

Error GAScene::remove_entry(const String &p_name) {
	return finish(_document.remove(to_utf8(p_name)), "remove_entry");
}

Error GAScene::move_entry(const String &p_name, int64_t p_index) {
	ERR_FAIL_COND_V_MSG(p_index < 0, godot::ERR_INVALID_PARAMETER, vformat("GAScene.move_entry: the index %d is below 0.", p_index));
	return finish(_document.move(to_utf8(p_name), size_t(p_index)), "move_entry");
}

int64_t GAScene::get_entry_count() const {
	return int64_t(_document.size());
}

bool GAScene::has_entry(const String &p_name) const {
	return _document.find(to_utf8(p_name)) != nullptr;
}

int64_t GAScene::get_index(const String &p_name) const {
	const size_t index = _document.index_of(to_utf8(p_name));
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

String GAScene::get_expression(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_expression");
	return entry ? to_godot(entry->text) : String();
}

Ref<Multivector> GAScene::get_value(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_value");
	return entry && entry->value ? Multivector::make(*entry->value) : Ref<Multivector>();
}

String GAScene::get_error(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_error");
	return entry && !entry->value ? to_godot(entry->value.error().message) : String();
}

String GAScene::get_description(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_description");
	return entry ? to_godot(playground::describe(*entry)) : String();
}

PackedStringArray GAScene::get_dependencies(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_dependencies");
	return entry && entry->expression ? to_strings(entry->expression->variables()) : PackedStringArray();
}

PackedStringArray GAScene::get_dependents(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_dependents");
	return entry ? to_strings(_document.dependents_of(entry->name)) : PackedStringArray();
}

Ref<Multivector> GAScene::evaluate(const String &p_expression) const {
	const cga::TextResult<cga::Multivector> value = _document.evaluate(to_utf8(p_expression));
	ERR_FAIL_COND_V_MSG(!value, Ref<Multivector>(), vformat("GAScene.evaluate: %s.", to_godot(value.error().describe())));
	return Multivector::make(*value);
}

String GAScene::get_expression_error(const String &p_expression) const {
	const cga::TextResult<cga::Multivector> value = _document.evaluate(to_utf8(p_expression));
	return value ? String() : to_godot(value.error().describe());
}

String GAScene::get_name_error(const String &p_name) const {
	const cga::Result<void, playground::Error> checked = _document.check_new_name(to_utf8(p_name));
	return checked ? String() : to_godot(checked.error().message);
}

PackedStringArray GAScene::get_load_errors() const {
	return to_strings(_load_errors);
}

} // namespace ga_godot
