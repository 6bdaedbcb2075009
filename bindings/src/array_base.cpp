#include <godot_cpp/variant/variant.hpp>

namespace godot::internal {

ArrayBase::ArrayBase(std::initializer_list<Variant> p_elements) {
	static_cast<Array *>(this)->resize(static_cast<int64_t>(p_elements.size()));
	int64_t index = 0;
	for (const Variant &element : p_elements) {
		(*this)[index++] = element;
	}
}

const Variant &ArrayBase::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(gdextension_interface::array_operator_index_const(_native_ptr(), p_index));
}

Variant &ArrayBase::operator[](int64_t p_index) {
	return *static_cast<Variant *>(gdextension_interface::array_operator_index(_native_ptr(), p_index));
}

const Variant *ArrayBase::begin() const {
	return static_cast<const Array *>(this)->is_empty() ? nullptr : &(*this)[0];
}

const Variant *ArrayBase::end() const {
	return begin() + static_cast<const Array *>(this)->size();
}

void ArrayBase::set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script) {
	gdextension_interface::array_set_typed(_native_ptr(), static_cast<GDExtensionVariantType>(p_type), p_class_name._native_ptr(), p_script._native_ptr());
}

const Variant &DictionaryBase::operator[](const Variant &p_key) const {
	return *static_cast<const Variant *>(gdextension_interface::dictionary_operator_index_const(_native_ptr(), p_key._native_ptr()));
}

Variant &DictionaryBase::operator[](const Variant &p_key) {
	return *static_cast<Variant *>(gdextension_interface::dictionary_operator_index(_native_ptr(), p_key._native_ptr()));
}

} // namespace godot::internal
