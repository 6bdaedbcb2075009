#pragma once

// godot-cpp aborts if a script passes a freed object to a method; bindings/ passes null. This file makes godot-cpp pass null
// too, for the types that our methods take. Include it where the class of such a method is defined.

#if __has_include(<godot_cpp/core/method_ptrcall.hpp>) // only in godot-cpp

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/binder_common.hpp>

namespace ga_godot {

template <class T>
struct FreedIsNull {
	static T *cast(const godot::Variant &argument) { return godot::Object::cast_to<T>(argument.get_validated_object()); }
};

} // namespace ga_godot

namespace godot {

template <>
struct VariantCaster<Camera3D *> : ga_godot::FreedIsNull<Camera3D> {};

template <>
struct VariantCaster<Node *> : ga_godot::FreedIsNull<Node> {};

} // namespace godot

#endif
