#include <godot_cpp/godot.hpp>

#include <godot_cpp/core/class_db.hpp>

#include <cstdio>

namespace godot {

namespace gdextension_interface {

GDExtensionClassLibraryPtr library = nullptr;
void *token = nullptr;

} // namespace gdextension_interface

namespace internal {

BuiltinFunctions builtin_functions[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX];

static void find_builtin_functions() {
	for (int i = GDEXTENSION_VARIANT_TYPE_BOOL; i < GDEXTENSION_VARIANT_TYPE_VARIANT_MAX; i++) {
		const GDExtensionVariantType type = static_cast<GDExtensionVariantType>(i);
		BuiltinFunctions &functions = builtin_functions[type];
		functions.to_variant = gdextension_interface::get_variant_from_type_constructor(type);
		functions.from_variant = gdextension_interface::get_variant_to_type_constructor(type);
		functions.construct = gdextension_interface::variant_get_ptr_constructor(type, 0);
		functions.copy = gdextension_interface::variant_get_ptr_constructor(type, 1);
		functions.destroy = gdextension_interface::variant_get_ptr_destructor(type);
	}
}

} // namespace internal

GDExtensionBinding::Callback GDExtensionBinding::initialize_callback = nullptr;

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) :
		_get_proc_address(p_get_proc_address), _initialization(r_initialization) {
	gdextension_interface::library = p_library;
	gdextension_interface::token = p_library;
	_initialization->minimum_initialization_level = GDEXTENSION_INITIALIZATION_CORE;
	_initialization->userdata = nullptr;
	_initialization->initialize = &initialize_level;
	_initialization->deinitialize = &deinitialize_level;
}

void GDExtensionBinding::InitObject::register_initializer(Callback p_initialize) const {
	initialize_callback = p_initialize;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const {
	_initialization->minimum_initialization_level = static_cast<GDExtensionInitializationLevel>(p_level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	if (const char *missing = gdextension_interface::load(_get_proc_address)) {
		// The engine's print_error may not have been loaded.
		fprintf(stderr, "ERROR: this extension requires a newer version of Godot: the engine does not have the function %s.\n", missing);
		return false;
	}
	internal::find_builtin_functions();
	return true;
}

void GDExtensionBinding::initialize_level(void *, GDExtensionInitializationLevel p_level) {
	internal::find_class_tags();
	ClassDB::current_level = p_level;
	if (initialize_callback) {
		initialize_callback(static_cast<ModuleInitializationLevel>(p_level));
	}
}

void GDExtensionBinding::deinitialize_level(void *, GDExtensionInitializationLevel p_level) {
	ClassDB::unregister_classes(p_level);
	if (p_level == GDEXTENSION_INITIALIZATION_CORE) {
		internal::Singleton::free_all();
	}
}

} // namespace godot
