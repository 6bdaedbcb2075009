@tool
extends RefCounted
## Sizes of the playground's controls.


## Factor for sizes in pixels: the editor's scale in the editor, and 1 in a game, where the window
## scales its contents.
static func scale() -> float:
	if not Engine.is_editor_hint():
		return 1.0
	# Exported games lack EditorInterface, so this script must not name the class.
	return Engine.get_singleton(&"EditorInterface").call(&"get_editor_scale")
