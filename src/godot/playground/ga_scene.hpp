#pragma once

#include "godot/algebra/multivector.hpp"
#include "playground/document/document.hpp"

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/variant.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ga_godot {

/// Named expressions that follow each other's changes; doc_classes/GAScene.xml documents it.
class GAScene : public godot::Resource {
	GDCLASS(GAScene, godot::Resource)

public:
	godot::Error add_entry(const godot::String &p_name, const godot::String &p_expression, int64_t p_index);
	godot::Error set_expression(const godot::String &p_name, const godot::String &p_expression);
	godot::Error rename_entry(const godot::String &p_from, const godot::String &p_to);
	godot::Error remove_entry(const godot::String &p_name);
	godot::Error move_entry(const godot::String &p_name, int64_t p_index);

	int64_t get_entry_count() const;
	bool has_entry(const godot::String &p_name) const;
	int64_t get_index(const godot::String &p_name) const;
	godot::PackedStringArray get_names() const;
	godot::String get_expression(const godot::String &p_name) const;
	godot::Ref<Multivector> get_value(const godot::String &p_name) const;
	godot::String get_error(const godot::String &p_name) const;
	godot::String get_description(const godot::String &p_name) const;
	godot::PackedStringArray get_dependencies(const godot::String &p_name) const;
	godot::PackedStringArray get_dependents(const godot::String &p_name) const;
	godot::Ref<Multivector> evaluate(const godot::String &p_expression) const;
	godot::String get_expression_error(const godot::String &p_expression) const;
	godot::String get_name_error(const godot::String &p_name) const;

	godot::Dictionary get_parameters(const godot::String &p_name) const;
	godot::Error set_parameter(const godot::String &p_name, const godot::String &p_key, const godot::Variant &p_value);

	godot::TypedArray<godot::Dictionary> get_handles(const godot::String &p_name, const godot::Vector3 &p_right) const;
	godot::Error drag_handle(const godot::String &p_name, const godot::Dictionary &p_handle, const godot::Vector3 &p_ray_origin, const godot::Vector3 &p_ray_direction, const godot::Vector3 &p_view, double p_step, double p_angle_step);

	godot::Error set_entry_attribute(const godot::String &p_name, const godot::String &p_key, const godot::Variant &p_value);
	godot::Variant get_entry_attribute(const godot::String &p_name, const godot::String &p_key) const;
	godot::Dictionary get_entry_attributes(const godot::String &p_name) const;
	godot::Error set_scene_attribute(const godot::String &p_key, const godot::Variant &p_value);
	godot::Variant get_scene_attribute(const godot::String &p_key) const;
	godot::Dictionary get_scene_attributes() const;

	godot::String to_json() const;
	godot::Error load_json(const godot::String &p_text);
	godot::PackedStringArray get_load_errors() const;

	/// For C++: null, and no error, if there is none.
	const playground::Entry *find_entry(const std::string &p_name) const { return _document.find(p_name); }

	/// What is stored in files: the JSON text, empty without entries.
	void set_document(const godot::String &p_text);
	godot::String get_document() const;

protected:
	static void _bind_methods();

private:
	// Null, and an error of that method, if there is no such entry.
	const playground::Entry *find(const godot::String &p_name, const char *p_method) const;
	// Tells of a change, or says why it was refused.
	godot::Error finish(const playground::ChangeResult &p_change, const char *p_method);
	godot::Error load(const godot::String &p_text, const char *p_what);

	playground::Document _document;
	std::vector<std::string> _load_errors;
};

} // namespace ga_godot
