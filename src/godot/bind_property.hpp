#pragma once

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <type_traits>

namespace ga_godot {

/// Binds a property of the registered class Self with its setter "set_NAME" and its getter, "is_NAME" for a bool and "get_NAME"
/// otherwise. For accessors that Self inherits from an unregistered base class, specify the template arguments.
template <class Self, class Set, class Get>
void bind_property(const char *argument, void (Self::*setter)(Set), Get (Self::*getter)() const, const godot::PropertyInfo &info) {
	const godot::String setter_name = godot::vformat("set_%s", info.name);
	const godot::String getter_name = godot::vformat(std::is_same_v<Get, bool> ? "is_%s" : "get_%s", info.name);
	godot::ClassDB::bind_method(godot::D_METHOD(godot::StringName(setter_name), argument), setter);
	godot::ClassDB::bind_method(godot::D_METHOD(godot::StringName(getter_name)), getter);
	godot::ClassDB::add_property(Self::get_class_static(), info, setter_name, getter_name);
}

} // namespace ga_godot
