@tool
extends "../playground/document/edit_history.gd"
## Adds the playground's actions to the editor's history, and undoes and redoes only these.

## The prefix of action names, by which the playground's actions are recognized.
const PREFIX := "GA Playground: "

var _undo_redo: EditorUndoRedoManager
# The numbers of the playground's actions at the top of the editor's undo and redo stacks.
var _undoable_count := 0
var _redoable_count := 0
# Set while the history changes by one of the playground's actions.
var _is_own_action := false


func _init(undo_redo: EditorUndoRedoManager) -> void:
	_undo_redo = undo_redo
	_undo_redo.history_changed.connect(_on_history_changed)
	_undo_redo.version_changed.connect(_on_history_changed)


# The last argument of create_action() determines the history: an embedded resource selects the
# history of the edited scene, and this object the global history.
func commit(title: String, scene: GAScene, before: String, after: String) -> void:
	_is_own_action = true
	if is_embedded(scene):
		_undo_redo.create_action(PREFIX + title, UndoRedo.MERGE_DISABLE, scene)
		_undo_redo.add_do_property(scene, &"document", after)
		_undo_redo.add_undo_property(scene, &"document", before)
	else:
		_undo_redo.create_action(PREFIX + title, UndoRedo.MERGE_DISABLE, self)
		_undo_redo.add_do_method(self, &"write", scene, after)
		_undo_redo.add_undo_method(self, &"write", scene, before)
	_undo_redo.commit_action(false)
	_is_own_action = false
	_undoable_count += 1
	_redoable_count = 0


static func is_embedded(scene: GAScene) -> bool:
	return scene.resource_path.contains("::")


## Called by the undo and redo actions.
func write(scene: GAScene, text: String) -> void:
	scene.document = text


## Whether the editor's undo would next undo one of the playground's actions on this scene. If so,
## leave it to the editor, so that the editor's state stays consistent.
func is_next_in_editor_undo(scene: GAScene) -> bool:
	return _undoable_count > 0 and _is_in_current_history(scene)


func is_next_in_editor_redo(scene: GAScene) -> bool:
	return _redoable_count > 0 and _is_in_current_history(scene)


## Call this before the editor undoes or redoes one of the playground's actions.
func expect_undo(is_redo: bool) -> void:
	_undoable_count += 1 if is_redo else -1
	_redoable_count += -1 if is_redo else 1
	_is_own_action = true
	_end_own_action.call_deferred()


## Undoes the last action if it is one of the playground's.
func undo(scene: GAScene) -> void:
	var steps := _undo_redo_of(scene)
	if steps.has_undo() and steps.get_current_action_name().begins_with(PREFIX):
		steps.undo()


func redo(scene: GAScene) -> void:
	var steps := _undo_redo_of(scene)
	if (
		steps.has_redo()
		and steps.get_action_name(steps.get_current_action() + 1).begins_with(PREFIX)
	):
		steps.redo()


func _undo_redo_of(scene: GAScene) -> UndoRedo:
	return _undo_redo.get_history_undo_redo(_history_of(scene))


func _history_of(scene: GAScene) -> int:
	return (
		_undo_redo.get_object_history_id(scene)
		if is_embedded(scene)
		else EditorUndoRedoManager.GLOBAL_HISTORY
	)


func _is_in_current_history(scene: GAScene) -> bool:
	var root := EditorInterface.get_edited_scene_root()
	var id := _history_of(scene)
	return (
		id == EditorUndoRedoManager.GLOBAL_HISTORY
		or (root != null and id == _undo_redo.get_object_history_id(root))
	)


func _end_own_action() -> void:
	_is_own_action = false


func _on_history_changed() -> void:
	if not _is_own_action:
		_undoable_count = 0
		_redoable_count = 0
