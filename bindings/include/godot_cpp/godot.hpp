#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/core/gdextension_interface_loader.hpp>

namespace godot {

namespace gdextension_interface {

// Handles that the engine passed when it loaded this library.
extern GDExtensionClassLibraryPtr library;
extern void *token;

} // namespace gdextension_interface

enum ModuleInitializationLevel {
	MODULE_INITIALIZATION_LEVEL_CORE = GDEXTENSION_INITIALIZATION_CORE,
	MODULE_INITIALIZATION_LEVEL_SERVERS = GDEXTENSION_INITIALIZATION_SERVERS,
	MODULE_INITIALIZATION_LEVEL_SCENE = GDEXTENSION_INITIALIZATION_SCENE,
	MODULE_INITIALIZATION_LEVEL_EDITOR = GDEXTENSION_INITIALIZATION_EDITOR,
	MODULE_INITIALIZATION_LEVEL_MAX
};

class GDExtensionBinding {
public:
	using Callback = void (*)(ModuleInitializationLevel p_level);

	// Create one in the library's entry function, which returns the result of init().
	class InitObject {
		GDExtensionInterfaceGetProcAddress _get_proc_address;
		GDExtensionInitialization *_initialization;

	public:
		InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization);

		void register_initializer(Callback p_initialize) const;
		void set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const;

		// Prints an error and returns false if the engine does not have a function that the bindings use.
		GDExtensionBool init() const;
	};

private:
	static Callback initialize_callback;

	static void initialize_level(void *, GDExtensionInitializationLevel p_level);
	static void deinitialize_level(void *, GDExtensionInitializationLevel p_level);
};

} // namespace godot
