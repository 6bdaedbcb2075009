#include <godot_cpp/core/call.hpp>

#include <godot_cpp/core/error_macros.hpp>

namespace godot::internal {

static const char *last_component(const char *p_qualified, int p_components) {
	const char *start = p_qualified + strlen(p_qualified);
	while (start > p_qualified && (start[-1] != ':' || --p_components > 0)) {
		start -= start[-1] == ':' ? 2 : 1;
	}
	return start;
}

String enum_class_name(const char *p_qualified) {
	return String(last_component(p_qualified, 2)).replace("::", ".");
}

StringName enum_short_name(const char *p_qualified) {
	return StringName(last_component(p_qualified, 1));
}

static void report_missing(const char *p_what, const String &p_name) {
	ERR_PRINT(vformat("This engine has no %s %s with the signature that the extension was built with; calls to it do nothing.", p_what, p_name));
}

GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash) {
	const GDExtensionMethodBindPtr method = gdextension_interface::classdb_get_method_bind(StringName(p_class)._native_ptr(), StringName(p_method)._native_ptr(), p_hash);
	if (method == nullptr) {
		report_missing("method", vformat("%s.%s", p_class, p_method));
	}
	return method;
}

GDExtensionPtrBuiltInMethod find_builtin_method(GDExtensionVariantType p_type, const char *p_method, int64_t p_hash) {
	const GDExtensionPtrBuiltInMethod method = gdextension_interface::variant_get_ptr_builtin_method(p_type, StringName(p_method)._native_ptr(), p_hash);
	if (method == nullptr) {
		report_missing("method", vformat("%s.%s", Variant::get_type_name(static_cast<Variant::Type>(p_type)), p_method));
	}
	return method;
}

GDExtensionPtrUtilityFunction find_utility_function(const char *p_function, int64_t p_hash) {
	const GDExtensionPtrUtilityFunction function = gdextension_interface::variant_get_ptr_utility_function(StringName(p_function)._native_ptr(), p_hash);
	if (function == nullptr) {
		report_missing("function", p_function);
	}
	return function;
}

Variant call_with_variants(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_owner, const GDExtensionConstVariantPtr *p_args, int64_t p_count) {
	if (unlikely(p_method == nullptr)) {
		return Variant();
	}
	Variant result{ Uninitialized() };
	GDExtensionCallError error{};
	gdextension_interface::object_method_bind_call(p_method, p_owner, p_args, p_count, result._native_ptr(), &error);
	return result;
}

void print_error(const ErrorPlace &p_place, const char *p_what) {
	gdextension_interface::print_error(p_what, p_place.function, p_place.file, p_place.line, false);
}

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
