#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/binder_common.hpp>

namespace godot {

class ObjectDB {
public:
	// The object with an id; null if it was freed.
	static Object *get_instance(uint64_t p_id) { return internal::get_binding(gdextension_interface::object_get_instance_from_id(p_id)); }
};

namespace internal {

// The parts of Arg that pointers and references to objects of class T share. Null and freed objects convert to null.
template <typename T>
struct ObjectArg : ArgBase<GDEXTENSION_VARIANT_TYPE_OBJECT> {
	static bool accepts(const Variant &p_variant) {
		const Object *object = p_variant.get_validated_object();
		return object == nullptr || Object::cast_to<T>(object) != nullptr;
	}
	static constexpr bool (*ACCEPTS)(const Variant &) = &accepts;

	static PropertyInfo info() { return PropertyInfo(Variant::OBJECT, StringName(), PROPERTY_HINT_RESOURCE_TYPE, T::get_class_static()); }
};

template <typename T>
struct Arg<T *> : ObjectArg<T> {
	using Result = GDExtensionObjectPtr;

	static GDExtensionObjectPtr encode(const T *p_value) { return p_value ? p_value->_owner : nullptr; }
	static T *decode(const void *p_argument) { return from_result(*static_cast<const GDExtensionObjectPtr *>(p_argument)); }
	static void store(void *r_result, const T *p_value) { *static_cast<GDExtensionObjectPtr *>(r_result) = encode(p_value); }
	static T *from_result(Result p_result) { return Object::cast_to<T>(get_binding(p_result)); }
	static T *from_variant(const Variant &p_variant) { return Object::cast_to<T>(p_variant.get_validated_object()); }
};

} // namespace internal

} // namespace godot
