#include <godot_cpp/core/call.hpp>

#include <godot_cpp/core/error_macros.hpp>

namespace godot::internal {

static void report_missing(const String &p_method) {
	ERR_PRINT(vformat("This engine does not have the method %s with the signature that the extension was built for; calls to it do nothing.", p_method));
}

GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash) {
	const GDExtensionMethodBindPtr method = gdextension_interface::classdb_get_method_bind(StringName(p_class)._native_ptr(), StringName(p_method)._native_ptr(), p_hash);
	if (method == nullptr) {
		report_missing(vformat("%s.%s", p_class, p_method));
	}
	return method;
}

GDExtensionPtrBuiltInMethod find_builtin_method(GDExtensionVariantType p_type, const char *p_method, int64_t p_hash) {
	const GDExtensionPtrBuiltInMethod method = gdextension_interface::variant_get_ptr_builtin_method(p_type, StringName(p_method)._native_ptr(), p_hash);
	if (method == nullptr) {
		report_missing(vformat("%s.%s", Variant::get_type_name(static_cast<Variant::Type>(p_type)), p_method));
	}
	return method;
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

} // namespace godot::internal
