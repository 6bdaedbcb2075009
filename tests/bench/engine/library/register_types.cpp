#include "native_blend.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

// The library of tools/bench engine: the compared methods in C++. Not part of the addon.

static void initialize(godot::ModuleInitializationLevel p_level) {
	if (p_level == godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		using bench::NativeBlend;
		GDREGISTER_CLASS(NativeBlend);
	}
}

extern "C" {

/// The entry point that ga_godot_bench.gdextension names.
__attribute__((visibility("default"))) GDExtensionBool ga_godot_bench_init(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	godot::GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
}
