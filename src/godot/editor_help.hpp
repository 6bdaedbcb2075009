#pragma once

namespace ga_godot {

/// The class reference of doc_classes/, one XML text a class, null at the end; made at build time.
extern const char *const EDITOR_HELP[];

/// Hands the class reference to the editor. Only at the EDITOR level: a game has no help to load it into.
void load_editor_help();

} // namespace ga_godot
