#pragma once

namespace ga_godot {

/// The XML text of each class in doc_classes/, null-terminated; generated at build time.
extern const char *const EDITOR_HELP[];

/// Adds the class reference to the editor's help. For MODULE_INITIALIZATION_LEVEL_EDITOR only: games have no help.
void load_editor_help();

} // namespace ga_godot
