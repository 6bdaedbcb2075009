@tool
extends "../playground/document/edit_history.gd"
## Adds the playground's actions to the editor's history, and undoes and redoes only these.

## The prefix of action names, by which the playground's actions are recognized.
const PREFIX := "GA Playground: "

var _undo_redo: EditorUndoRedoManager
# Numbers of the playground's actions that the editor's own undo and redo would take next.
var _newest := 0
var _undone := 0
var _is_own := false


func _init(undo_redo: EditorUndoRedoManager) -> void:
	_undo_redo = undo_redo
	_undo_redo.history_changed.connect(_on_done_by_others)
	_undo_redo.version_changed.connect(_on_done_by_others)


# The object of an action determines its history: an embedded resource that of the edited scene,
# this object the global one.
func commit(title: String, scene: GAScene, before: String, after: String) -> void:
	_is_own = true
	if is_embedded(scene):
		_undo_redo.create_action(PREFIX + title, UndoRedo.MERGE_DISABLE, scene)
		_undo_redo.add_do_property(scene, &"document", after)
		_undo_redo.add_undo_property(scene, &"document", before)
	else:
		_undo_redo.create_action(PREFIX + title, UndoRedo.MERGE_DISABLE, self)
		_undo_redo.add_do_method(self, &"write", scene, after)
		_undo_redo.add_undo_method(self, &"write", scene, before)
	_undo_redo.commit_action(false)
	_is_own = false
	_newest += 1
	_undone = 0


static func is_embedded(scene: GAScene) -> bool:
	return scene.resource_path.contains("::")


## Called by the actions.
func write(scene: GAScene, text: String) -> void:
	scene.document = text


## Whether the editor's own undo would undo an action of this scene next. It should then do so, as
## it keeps its own records.
func is_editors_undo(scene: GAScene) -> bool:
	return _newest > 0 and _is_in_reach(scene)


func is_editors_redo(scene: GAScene) -> bool:
	return _undone > 0 and _is_in_reach(scene)


## To be called before the editor's own undo or redo takes an action of the playground.
func expect_undo(is_redo: bool) -> void:
	_newest += 1 if is_redo else -1
	_undone += -1 if is_redo else 1
	_is_own = true
	_expect_others.call_deferred()


## Undoes the last action if it is one of the playground's.
func undo(scene: GAScene) -> void:
	var steps := _steps_of(scene)
	if steps.has_undo() and steps.get_current_action_name().begins_with(PREFIX):
		steps.undo()


func redo(scene: GAScene) -> void:
	var steps := _steps_of(scene)
	if (
		steps.has_redo()
		and steps.get_action_name(steps.get_current_action() + 1).begins_with(PREFIX)
	):
		steps.redo()


func _steps_of(scene: GAScene) -> UndoRedo:
	return _undo_redo.get_history_undo_redo(_history_of(scene))


func _history_of(scene: GAScene) -> int:
	return (
		_undo_redo.get_object_history_id(scene)
		if is_embedded(scene)
		else EditorUndoRedoManager.GLOBAL_HISTORY
	)


func _is_in_reach(scene: GAScene) -> bool:
	var root := EditorInterface.get_edited_scene_root()
	var id := _history_of(scene)
	return (
		id == EditorUndoRedoManager.GLOBAL_HISTORY
		or (root != null and id == _undo_redo.get_object_history_id(root))
	)


func _expect_others() -> void:
	_is_own = false


func _on_done_by_others() -> void:
	if not _is_own:
		_newest = 0
		_undone = 0
