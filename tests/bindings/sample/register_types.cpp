#include "sample_node.hpp"
#include "sample_values.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

static void initialize(godot::ModuleInitializationLevel level) {
	if (level == godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(bindings_sample::SampleNote);
		GDREGISTER_CLASS(bindings_sample::SampleValues);
		GDREGISTER_CLASS(bindings_sample::SampleNode);
		GDREGISTER_CLASS(bindings_sample::SampleChild);
		GDREGISTER_CLASS(bindings_sample::SampleMover);
	} else if (level == godot::MODULE_INITIALIZATION_LEVEL_EDITOR) {
		godot::gdextension_interface::editor_help_load_xml_from_utf8_chars("<?xml version=\"1.0\" encoding=\"UTF-8\" ?><class name=\"SampleNote\" inherits=\"Resource\"><brief_description>A note.</brief_description><description></description></class>");
	}
}

extern "C" GDExtensionBool GDE_EXPORT sample_init(GDExtensionInterfaceGetProcAddress get_proc_address, GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization) {
	godot::GDExtensionBinding::InitObject init(get_proc_address, library, initialization);
	init.register_initializer(initialize);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
