@tool
@abstract
extends RefCounted
## An undo history of changes to a scene.

## Adds one action to the history: the scene's document was `before` and already is `after`.
@abstract func commit(title: String, scene: GAScene, before: String, after: String) -> void
