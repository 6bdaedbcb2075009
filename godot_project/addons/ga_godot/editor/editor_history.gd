@tool
extends "../playground/edit_history.gd"
## The editor's history.

var _undo_redo: EditorUndoRedoManager


func _init(undo_redo: EditorUndoRedoManager) -> void:
	_undo_redo = undo_redo


# The history of an action is that of the object that it is done to: of the edited scene for a resource within it, else
# of the project, for which this object stands.
func commit(title: String, scene: GAScene, before: String, after: String) -> void:
	if scene.resource_path.contains("::"):
		_undo_redo.create_action(title, UndoRedo.MERGE_DISABLE, scene)
		_undo_redo.add_do_property(scene, &"document", after)
		_undo_redo.add_undo_property(scene, &"document", before)
	else:
		_undo_redo.create_action(title, UndoRedo.MERGE_DISABLE, self)
		_undo_redo.add_do_method(self, &"write", scene, after)
		_undo_redo.add_undo_method(self, &"write", scene, before)
	_undo_redo.commit_action(false)


## What a step does.
func write(scene: GAScene, text: String) -> void:
	scene.document = text
