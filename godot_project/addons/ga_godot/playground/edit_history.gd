@tool
@abstract
extends RefCounted
## Where changes of a scene are kept so that they can be undone.


## Makes the scene's text `after`, as one step.
@abstract func commit(title: String, scene: GAScene, before: String, after: String) -> void
