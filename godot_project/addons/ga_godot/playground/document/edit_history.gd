@tool
@abstract
extends RefCounted
## Where changes of a scene are kept so that they can be undone.

## Keeps what was done as one step: the scene's text was `before`, and is `after` already.
@abstract func commit(title: String, scene: GAScene, before: String, after: String) -> void
