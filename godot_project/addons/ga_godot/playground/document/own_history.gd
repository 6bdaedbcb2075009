@tool
extends "edit_history.gd"
## The playground's own undo history, for use in a running game.

signal changed

var _undo_redo := UndoRedo.new()


func _init() -> void:
	_undo_redo.version_changed.connect(changed.emit)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		_undo_redo.set_block_signals(true)
		_undo_redo.free()


func commit(title: String, scene: GAScene, before: String, after: String) -> void:
	_undo_redo.create_action(title)
	_undo_redo.add_do_property(scene, &"document", after)
	_undo_redo.add_undo_property(scene, &"document", before)
	_undo_redo.commit_action(false)


## Returns the title of the undone action; empty if there is none.
func undo() -> String:
	var title := _undo_redo.get_current_action_name() if _undo_redo.has_undo() else ""
	_undo_redo.undo()
	return title


## Returns the title of the redone action; empty if there is none.
func redo() -> String:
	return _undo_redo.get_current_action_name() if _undo_redo.redo() else ""


func has_undo() -> bool:
	return _undo_redo.has_undo()


func has_redo() -> bool:
	return _undo_redo.has_redo()


func clear() -> void:
	_undo_redo.clear_history()
