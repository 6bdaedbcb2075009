@tool
extends RefCounted
## Sizes of the playground's controls.


## The factor of sizes in pixels: the editor's scale. In a game, the window scales its contents.
static func scale() -> float:
	if not Engine.is_editor_hint():
		return 1.0
	# Exported games do not have the class, so that it cannot be named here.
	return Engine.get_singleton(&"EditorInterface").call(&"get_editor_scale")
