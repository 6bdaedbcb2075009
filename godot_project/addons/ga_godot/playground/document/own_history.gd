@tool
extends "edit_history.gd"
## A history of the playground's own, for a running game.

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


## The title of what was undone; empty if there was nothing.
func undo() -> String:
	var title := _undo_redo.get_current_action_name() if _undo_redo.has_undo() else ""
	_undo_redo.undo()
	return title


## The title of what was done again; empty if there was nothing.
func redo() -> String:
	return _undo_redo.get_current_action_name() if _undo_redo.redo() else ""


func has_undo() -> bool:
	return _undo_redo.has_undo()


func has_redo() -> bool:
	return _undo_redo.has_redo()


func clear() -> void:
	_undo_redo.clear_history()
