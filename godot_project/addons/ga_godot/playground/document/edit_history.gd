@tool
extends RefCounted
## An undo history of changes to a scene.


## Adds one action to the history, which has already changed the scene's document from `before` to
## `after`.
func commit(_title: String, _scene: GAScene, _before: String, _after: String) -> void:
	assert(false, "commit() is not overridden")
