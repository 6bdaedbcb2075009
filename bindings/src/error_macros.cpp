#include <godot_cpp/core/error_macros.hpp>

#include <godot_cpp/core/gdextension_interface_loader.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot::internal {

void print_error(const ErrorPlace &p_place, const char *p_what, const char *p_message) {
	gdextension_interface::print_error_with_message(p_what, p_message, p_place.function, p_place.file, p_place.line, false);
}

void print_error(const ErrorPlace &p_place, const char *p_what, const String &p_message) {
	print_error(p_place, p_what, p_message.utf8().get_data());
}

void print_warning(const ErrorPlace &p_place, const char *p_what) {
	gdextension_interface::print_warning(p_what, p_place.function, p_place.file, p_place.line, false);
}

void print_warning(const ErrorPlace &p_place, const String &p_what) {
	print_warning(p_place, p_what.utf8().get_data());
}

} // namespace godot::internal
