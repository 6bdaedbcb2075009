#include "native_blend.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

// The extension that `tools/bench engine` loads: C++ implementations to compare with. Not part of the addon.

static void initialize(godot::ModuleInitializationLevel level) {
	if (level == godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		using bench::NativeBlend;
		GDREGISTER_CLASS(NativeBlend);
	}
}

extern "C" {

/// The entry point that ga_godot_bench.gdextension names.
GDExtensionBool GDE_EXPORT ga_godot_bench_init(GDExtensionInterfaceGetProcAddress get_proc_address, GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization) {
	godot::GDExtensionBinding::InitObject init(get_proc_address, library, initialization);
	init.register_initializer(initialize);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
}
