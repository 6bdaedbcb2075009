#include "godot/algebra/multivector.hpp"
#include "godot/drawing/ga_node_3d.hpp"
#include "godot/motion/motor_pool.hpp"
#include "godot/motion/multivector_lerp.hpp"
#include "godot/net/motor_codec.hpp"
#include "godot/net/motor_receiver.hpp"
#include "godot/net/motor_sender.hpp"
#include "godot/net/motor_synchronizer.hpp"
#include "godot/playground/ga_scene.hpp"
#include "godot/thread_guard.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

namespace ga_godot {

/// The XML text of each class in doc_classes/, null-terminated; generated at build time.
extern const char *const EDITOR_HELP[];

static void initialize(godot::ModuleInitializationLevel level) {
	if (level == godot::MODULE_INITIALIZATION_LEVEL_SCENE) {
		remember_main_thread();
		GDREGISTER_CLASS(Multivector);
		GDREGISTER_CLASS(GAScene);
		GDREGISTER_CLASS(GANode3D);
		GDREGISTER_CLASS(MultivectorLerp);
		GDREGISTER_CLASS(MotorPool);
		GDREGISTER_CLASS(MotorCodec);
		GDREGISTER_CLASS(MotorSender);
		GDREGISTER_CLASS(MotorReceiver);
		GDREGISTER_CLASS(MotorSynchronizer);
	} else if (level == godot::MODULE_INITIALIZATION_LEVEL_EDITOR) {
		for (const char *const *xml = EDITOR_HELP; *xml != nullptr; xml++) {
			godot::gdextension_interface::editor_help_load_xml_from_utf8_chars(*xml);
		}
	}
}

} // namespace ga_godot

extern "C" {

/// The entry point that ga_godot.gdextension names.
GDExtensionBool GDE_EXPORT ga_godot_init(GDExtensionInterfaceGetProcAddress get_proc_address, GDExtensionClassLibraryPtr library, GDExtensionInitialization *initialization) {
	godot::GDExtensionBinding::InitObject init(get_proc_address, library, initialization);
	init.register_initializer(ga_godot::initialize);
	init.set_minimum_library_initialization_level(godot::MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
}
