#include "sample_node.hpp"
#include "sample_values.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

static void initialize(godot::ModuleInitializationLevel p_level) {
	if (p_level == godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(bindings_sample::SampleNote);
		GDREGISTER_CLASS(bindings_sample::SampleValues);
		GDREGISTER_CLASS(bindings_sample::SampleNode);
		GDREGISTER_CLASS(bindings_sample::SampleChild);
		GDREGISTER_CLASS(bindings_sample::SampleMover);
	} else if (p_level == godot::MODULE_INITIALIZATION_LEVEL_EDITOR) {
		godot::gdextension_interface::editor_help_load_xml_from_utf8_chars("<?xml version=\"1.0\" encoding=\"UTF-8\" ?><class name=\"SampleNote\" inherits=\"Resource\"><brief_description>A note.</brief_description><description></description></class>");
	}
}

static void terminate(godot::ModuleInitializationLevel) {
}

extern "C" __attribute__((visibility("default"))) GDExtensionBool sample_init(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	godot::GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
