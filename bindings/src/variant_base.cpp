#include <godot_cpp/variant/variant.hpp>

#include <godot_cpp/classes/object.hpp>

namespace godot::internal {

VariantBase::VariantBase(bool p_value) {
	const GDExtensionBool value = p_value;
	construct(BOOL, &value);
}

VariantBase::VariantBase(int64_t p_value) {
	construct(INT, &p_value);
}

VariantBase::VariantBase(double p_value) {
	construct(FLOAT, &p_value);
}

VariantBase::VariantBase(const Object *p_value) {
	const GDExtensionObjectPtr owner = p_value ? p_value->_owner : nullptr;
	construct(OBJECT, static_cast<const void *>(&owner));
}

VariantBase::operator bool() const {
	return convert<GDExtensionBool>(BOOL);
}

VariantBase::operator int64_t() const {
	return convert<int64_t>(INT);
}

VariantBase::operator double() const {
	return convert<double>(FLOAT);
}

// By id, because the address of a freed object is not valid.
Object *VariantBase::get_validated_object() const {
	if (get_type() != OBJECT) {
		return nullptr;
	}
	const GDObjectInstanceID id = gdextension_interface::variant_get_object_instance_id(_opaque);
	return get_binding(id ? gdextension_interface::object_get_instance_from_id(id) : nullptr);
}

String VariantBase::get_type_name(Type p_type) {
	String name{ Uninitialized() };
	gdextension_interface::variant_get_type_name(static_cast<GDExtensionVariantType>(p_type), name._native_ptr());
	return name;
}

bool VariantBase::can_convert_strict(Type p_from, Type p_to) {
	return gdextension_interface::variant_can_convert_strict(static_cast<GDExtensionVariantType>(p_from), static_cast<GDExtensionVariantType>(p_to));
}

} // namespace godot::internal
