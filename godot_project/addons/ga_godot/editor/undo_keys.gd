@tool
extends Node
## Handles the undo and redo shortcuts while the focus is in the dock. They apply to the
## playground's last action, regardless of later actions in the editor.

const EditorHistory := preload("editor_history.gd")
const PlaygroundDocument := preload("../playground/document/playground_document.gd")

var _dock: Control
var _document: PlaygroundDocument
var _history: EditorHistory


func _init(dock: Control, document: PlaygroundDocument, history: EditorHistory) -> void:
	_dock = dock
	_document = document
	_history = history


# _input() runs before the controls. In _shortcut_input(), an empty text field would already have
# consumed the event.
func _input(event: InputEvent) -> void:
	if not event is InputEventKey:
		return
	var is_undo := event.is_action_pressed(&"ui_undo", true, true)
	if not is_undo and not event.is_action_pressed(&"ui_redo", true, true):
		return
	var focused := get_viewport().gui_get_focus_owner()
	if focused == null or not _dock.is_ancestor_of(focused) or _is_typing(focused):
		return
	var scene := _document.scene
	if (
		_history.is_next_in_editor_undo(scene)
		if is_undo
		else _history.is_next_in_editor_redo(scene)
	):
		_history.expect_undo(not is_undo)
		_release_until_handled(focused as LineEdit)
		return
	if is_undo:
		_history.undo(scene)
	else:
		_history.redo(scene)
	get_viewport().set_input_as_handled()


func _is_typing(focused: Control) -> bool:
	var edit := focused as LineEdit
	return edit != null and edit.is_editing() and not edit.text.is_empty()


# Otherwise the text field would consume the shortcut before the editor.
func _release_until_handled(edit: LineEdit) -> void:
	if edit != null:
		edit.release_focus()
		edit.edit.call_deferred()
