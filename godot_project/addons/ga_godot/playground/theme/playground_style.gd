@tool
extends RefCounted
## Sizes of the playground's controls.


## By what sizes in pixels are multiplied: the editor's scale in the editor. A game's window scales its contents itself.
static func scale() -> float:
	if not Engine.is_editor_hint():
		return 1.0
	# Not by its name, which an exported game does not know.
	return Engine.get_singleton(&"EditorInterface").call(&"get_editor_scale")
