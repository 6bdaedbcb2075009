#include <godot_cpp/variant/variant.hpp>

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/call.hpp>

namespace godot {

static bool evaluate(GDExtensionVariantOperator p_operator, const Variant &p_left, const Variant &p_right) {
	Variant result{ internal::Uninitialized() };
	GDExtensionBool valid = false;
	gdextension_interface::variant_evaluate(p_operator, p_left._native_ptr(), p_right._native_ptr(), result._native_ptr(), &valid);
	return valid && result.booleanize();
}

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
	construct(OBJECT, &owner);
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

// By id, because the address of a freed object says nothing.
Object *Variant::get_validated_object() const {
	if (get_type() != OBJECT) {
		return nullptr;
	}
	const GDObjectInstanceID id = gdextension_interface::variant_get_object_instance_id(opaque);
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
	return evaluate(GDEXTENSION_VARIANT_OP_EQUAL, *this, p_other);
}

bool Variant::operator<(const Variant &p_other) const {
	return evaluate(GDEXTENSION_VARIANT_OP_LESS, *this, p_other);
}

String Variant::stringify() const {
	String text{ internal::Uninitialized() };
	gdextension_interface::variant_stringify(opaque, text._native_ptr());
	return text;
}

bool Variant::booleanize() const {
	return gdextension_interface::variant_booleanize(opaque);
}

namespace internal {

StringBase::StringBase(const char *p_latin1) :
		Opaque(Uninitialized()) {
	gdextension_interface::string_new_with_latin1_chars(_native_ptr(), p_latin1);
}

String StringBase::utf8(const char *p_utf8, int64_t p_length) {
	String text{ Uninitialized() };
	gdextension_interface::string_new_with_utf8_chars_and_len(text._native_ptr(), p_utf8, p_length);
	return text;
}

CharString StringBase::utf8() const {
	CharString result;
	result.text.resize(static_cast<size_t>(gdextension_interface::string_to_utf8_chars(_native_ptr(), nullptr, 0)));
	gdextension_interface::string_to_utf8_chars(_native_ptr(), result.text.data(), result.length());
	return result;
}

String &StringBase::operator+=(const String &p_other) {
	gdextension_interface::string_operator_plus_eq_string(_native_ptr(), p_other._native_ptr());
	return static_cast<String &>(*this);
}

const char32_t &StringBase::operator[](int64_t p_index) const {
	return *gdextension_interface::string_operator_index_const(_native_ptr(), p_index);
}

StringNameBase::StringNameBase(const char *p_latin1, bool p_static) :
		Opaque(Uninitialized()) {
	gdextension_interface::string_name_new_with_latin1_chars(_native_ptr(), p_latin1, p_static);
}

ArrayBase::ArrayBase(std::initializer_list<Variant> p_elements) {
	static_cast<Array *>(this)->resize(static_cast<int64_t>(p_elements.size()));
	Variant *target = begin();
	for (const Variant &element : p_elements) {
		*target++ = element;
	}
}

const Variant &ArrayBase::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(gdextension_interface::array_operator_index_const(_native_ptr(), p_index));
}

Variant &ArrayBase::operator[](int64_t p_index) {
	return *static_cast<Variant *>(gdextension_interface::array_operator_index(_native_ptr(), p_index));
}

Variant *ArrayBase::begin() {
	return static_cast<Array *>(this)->is_empty() ? nullptr : &(*this)[0];
}

Variant *ArrayBase::end() {
	return begin() + static_cast<Array *>(this)->size();
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

} // namespace internal

String operator+(const char *p_left, const String &p_right) {
	return String(p_left) + p_right;
}

String itos(int64_t p_value) {
	return String::num_int64(p_value);
}

} // namespace godot
