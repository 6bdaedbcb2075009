#include "godot/playground/ga_scene.hpp"

#include <godot_cpp/core/class_db.hpp>

// What scripts see of GAScene. The order is that of the class's header.

namespace ga_godot {

void GAScene::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("add_entry", "name", "expression", "index"), &GAScene::add_entry, DEFVAL(-1));
	ClassDB::bind_method(D_METHOD("set_expression", "name", "expression"), &GAScene::set_expression);
	ClassDB::bind_method(D_METHOD("rename_entry", "from", "to"), &GAScene::rename_entry);
	ClassDB::bind_method(D_METHOD("remove_entry", "name"), &GAScene::remove_entry);
	ClassDB::bind_method(D_METHOD("move_entry", "name", "index"), &GAScene::move_entry);

	ClassDB::bind_method(D_METHOD("get_entry_count"), &GAScene::get_entry_count);
	ClassDB::bind_method(D_METHOD("has_entry", "name"), &GAScene::has_entry);
	ClassDB::bind_method(D_METHOD("get_index", "name"), &GAScene::get_index);
	ClassDB::bind_method(D_METHOD("get_names"), &GAScene::get_names);
	ClassDB::bind_method(D_METHOD("get_expression", "name"), &GAScene::get_expression);
	ClassDB::bind_method(D_METHOD("get_value", "name"), &GAScene::get_value);
	ClassDB::bind_method(D_METHOD("get_error", "name"), &GAScene::get_error);
	ClassDB::bind_method(D_METHOD("get_description", "name"), &GAScene::get_description);
	ClassDB::bind_method(D_METHOD("get_dependencies", "name"), &GAScene::get_dependencies);
	ClassDB::bind_method(D_METHOD("get_dependents", "name"), &GAScene::get_dependents);
	ClassDB::bind_method(D_METHOD("evaluate", "expression"), &GAScene::evaluate);
	ClassDB::bind_method(D_METHOD("get_expression_error", "expression"), &GAScene::get_expression_error);
	ClassDB::bind_method(D_METHOD("get_name_error", "name"), &GAScene::get_name_error);

	ClassDB::bind_method(D_METHOD("get_parameters", "name"), &GAScene::get_parameters);
	ClassDB::bind_method(D_METHOD("set_parameter", "name", "key", "value"), &GAScene::set_parameter);

	ClassDB::bind_method(D_METHOD("get_handles", "name", "right"), &GAScene::get_handles, DEFVAL(godot::Vector3(1, 0, 0)));
	ClassDB::bind_method(D_METHOD("drag_handle", "name", "handle", "ray_origin", "ray_direction", "view", "step", "angle_step"), &GAScene::drag_handle, DEFVAL(0.0), DEFVAL(0.0));

	ClassDB::bind_method(D_METHOD("set_entry_attribute", "name", "key", "value"), &GAScene::set_entry_attribute);
	ClassDB::bind_method(D_METHOD("get_entry_attribute", "name", "key"), &GAScene::get_entry_attribute);
	ClassDB::bind_method(D_METHOD("get_entry_attributes", "name"), &GAScene::get_entry_attributes);
	ClassDB::bind_method(D_METHOD("set_scene_attribute", "key", "value"), &GAScene::set_scene_attribute);
	ClassDB::bind_method(D_METHOD("get_scene_attribute", "key"), &GAScene::get_scene_attribute);
	ClassDB::bind_method(D_METHOD("get_scene_attributes"), &GAScene::get_scene_attributes);

	ClassDB::bind_method(D_METHOD("to_json"), &GAScene::to_json);
	ClassDB::bind_method(D_METHOD("load_json", "text"), &GAScene::load_json);
	ClassDB::bind_method(D_METHOD("get_load_errors"), &GAScene::get_load_errors);

	ClassDB::bind_method(D_METHOD("set_document", "text"), &GAScene::set_document);
	ClassDB::bind_method(D_METHOD("get_document"), &GAScene::get_document);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "document", godot::PROPERTY_HINT_NONE, "", godot::PROPERTY_USAGE_STORAGE), "set_document", "get_document");

	ADD_SIGNAL(godot::MethodInfo("entries_changed", PropertyInfo(Variant::PACKED_STRING_ARRAY, "names")));
}

} // namespace ga_godot
