#include <godot_cpp/variant/variant.hpp>

#include <godot_cpp/classes/object.hpp>

namespace godot {

Variant::Variant(bool p_value) {
	const GDExtensionBool value = p_value;
	construct(BOOL, &value);
}

Variant::Variant(int64_t p_value) {
	construct(INT, &p_value);
}

Variant::Variant(double p_value) {
	construct(FLOAT, &p_value);
}

Variant::Variant(const Object *p_value) {
	const GDExtensionObjectPtr owner = p_value ? p_value->_owner : nullptr;
	construct(OBJECT, static_cast<const void *>(&owner));
}

Variant::operator bool() const {
	return convert<GDExtensionBool>(BOOL);
}

Variant::operator int64_t() const {
	return convert<int64_t>(INT);
}

Variant::operator double() const {
	return convert<double>(FLOAT);
}

// By id, because the address of a freed object is not valid.
Object *Variant::get_validated_object() const {
	if (get_type() != OBJECT) {
		return nullptr;
	}
	const GDObjectInstanceID id = gdextension_interface::variant_get_object_instance_id(_opaque);
	return internal::get_binding(id ? gdextension_interface::object_get_instance_from_id(id) : nullptr);
}

String Variant::get_type_name(Type p_type) {
	String name{ internal::Uninitialized() };
	gdextension_interface::variant_get_type_name(static_cast<GDExtensionVariantType>(p_type), name._native_ptr());
	return name;
}

bool Variant::can_convert_strict(Type p_from, Type p_to) {
	return gdextension_interface::variant_can_convert_strict(static_cast<GDExtensionVariantType>(p_from), static_cast<GDExtensionVariantType>(p_to));
}

bool Variant::operator==(const Variant &p_other) const {
	Variant equal{ internal::Uninitialized() };
	GDExtensionBool valid = false;
	gdextension_interface::variant_evaluate(GDEXTENSION_VARIANT_OP_EQUAL, _opaque, p_other._opaque, equal._opaque, &valid);
	return valid && equal;
}

} // namespace godot
