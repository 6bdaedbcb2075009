@tool
@abstract
extends RefCounted
## An undo history of changes to a scene.

## Adds one action to the history, which has already changed the scene's document from `before` to
## `after`.
@abstract func commit(title: String, scene: GAScene, before: String, after: String) -> void
