#include "godot/editor_help.hpp"

#include <godot_cpp/godot.hpp>

namespace ga_godot {

void load_editor_help() {
	for (const char *const *xml = EDITOR_HELP; *xml != nullptr; xml++) {
		godot::gdextension_interface::editor_help_load_xml_from_utf8_chars(*xml);
	}
}

} // namespace ga_godot
