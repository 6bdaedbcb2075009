#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace godot {

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
	result._text.resize(static_cast<size_t>(gdextension_interface::string_to_utf8_chars(_native_ptr(), nullptr, 0)));
	gdextension_interface::string_to_utf8_chars(_native_ptr(), result._text.data(), result.length());
	return result;
}

String &StringBase::operator+=(const String &p_other) {
	gdextension_interface::string_operator_plus_eq_string(_native_ptr(), p_other._native_ptr());
	return static_cast<String &>(*this);
}

StringNameBase::StringNameBase(const char *p_latin1, bool p_static) :
		Opaque(Uninitialized()) {
	gdextension_interface::string_name_new_with_latin1_chars(_native_ptr(), p_latin1, p_static);
}

} // namespace internal

} // namespace godot
