#pragma once

#include "godot/algebra/multivector.hpp"
#include "godot/thread_guard.hpp"
#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/variant.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ga_godot {

/// A playground::Document as a resource; doc_classes/GAScene.xml documents it.
class GAScene : public godot::Resource, public OneThread<GAScene> {
	GDCLASS(GAScene, godot::Resource)

public:
	godot::Error add_entry(const godot::String &name, const godot::String &expression, int64_t index);
	godot::Error set_expression(const godot::String &name, const godot::String &expression);
	godot::Error rename_entry(const godot::String &from, const godot::String &to);
	godot::Error remove_entry(const godot::String &name);
	godot::Error move_entry(const godot::String &name, int64_t index);

	int64_t get_entry_count() const;
	bool has_entry(const godot::String &name) const;
	int64_t get_index(const godot::String &name) const;
	godot::PackedStringArray get_names() const;
	godot::String get_expression(const godot::String &name) const;
	godot::Ref<Multivector> get_value(const godot::String &name) const;
	godot::String get_error(const godot::String &name) const;
	godot::String get_description(const godot::String &name) const;
	godot::PackedStringArray get_dependencies(const godot::String &name) const;
	godot::PackedStringArray get_dependents(const godot::String &name) const;
	godot::Ref<Multivector> evaluate(const godot::String &expression) const;
	godot::Dictionary describe_expression(const godot::String &text, const godot::StringName &as_entry) const;
	godot::String get_name_error(const godot::String &name) const;

	godot::Dictionary get_parameters(const godot::String &name) const;
	godot::Error set_parameter(const godot::String &name, const godot::String &key, const godot::Variant &value);

	godot::TypedArray<godot::Dictionary> get_handles(const godot::String &name, const godot::Vector3 &right) const;
	godot::Error drag_handle(const godot::String &name, const godot::Dictionary &handle, const godot::Vector3 &ray_origin, const godot::Vector3 &ray_direction, const godot::Vector3 &view, double step, double angle_step);

	godot::Error set_entry_attribute(const godot::String &name, const godot::String &key, const godot::Variant &value);
	godot::Variant get_entry_attribute(const godot::String &name, const godot::String &key) const;
	godot::Dictionary get_entry_attributes(const godot::String &name) const;
	godot::Error set_scene_attribute(const godot::String &key, const godot::Variant &value);
	godot::Variant get_scene_attribute(const godot::String &key) const;
	godot::Dictionary get_scene_attributes() const;

	godot::String to_json() const;
	godot::Error load_json(const godot::String &text);
	godot::Error load_json_utf8(const godot::PackedByteArray &bytes);
	godot::PackedStringArray get_load_errors() const;

	/// For C++: null, without an error message, if there is no such entry.
	const playground::Entry *find_entry(const std::string &name) const { return _document.find(name); }

	/// The stored property: the JSON text, empty for an empty scene.
	void set_document(const godot::String &text);
	godot::String get_document() const;

protected:
	static void _bind_methods();

private:
	// Returns null and prints an error that names the method if there is no such entry.
	const playground::Entry *find(const godot::String &name, const char *method) const;
	// Emits the signals of an accepted change, or reports why it was refused.
	godot::Error finish(const playground::ChangeResult &change, const char *method);
	godot::Error load(const godot::String &text, const char *member);
	godot::Error load(playground::LoadedDocument loaded, const char *member);

	playground::Document _document;
	std::vector<std::string> _load_errors;
};

} // namespace ga_godot
