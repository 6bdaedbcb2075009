@tool
extends RefCounted
## The scene that the playground shows, with its file and its undo history.

## Emitted when another scene is shown, or the file of the scene changes.
signal scene_switched
## Emitted when the scene changes, including by undo and redo.
signal changed
## Forwarded from GAScene.entries_changed, before `changed`.
signal entries_changed(names: PackedStringArray)

const EditHistory := preload("edit_history.gd")

var scene: GAScene
## The resource path; empty for a scene without a file.
var path := ""

var _history: EditHistory
var _saved_text := ""
var _text_before_gesture := ""
var _in_gesture := false
# While change() runs, `changed` is delayed until its end.
var _is_changing := false


func _init(history: EditHistory) -> void:
	_history = history
	show_scene(GAScene.new(), "")


func show_scene(new_scene: GAScene, new_path: String) -> void:
	if scene != null:
		scene.changed.disconnect(_on_changed)
		scene.entries_changed.disconnect(_on_entries_changed)
	scene = new_scene
	path = new_path
	_in_gesture = false
	_saved_text = scene.document
	scene.changed.connect(_on_changed)
	scene.entries_changed.connect(_on_entries_changed)
	scene_switched.emit()
	changed.emit()


func is_unsaved() -> bool:
	return _in_gesture or scene.document != _saved_text


## Whether the scene is embedded in another file, such as a .tscn, and is saved with it.
func is_embedded() -> bool:
	return path.contains("::")


## The file that contains the scene; empty if there is none.
func get_file() -> String:
	return path.get_slice("::", 0)


## The scene's text when it was opened or last saved.
func get_saved_text() -> String:
	return _saved_text


func mark_saved(new_path: String) -> void:
	path = new_path
	_saved_text = scene.document
	scene_switched.emit()


## Calls `edit` with the scene. All its changes become one action in the history.
func change(title: String, edit: Callable) -> void:
	var before := scene.document
	_is_changing = true
	edit.call(scene)
	_is_changing = false
	var after := scene.document
	if before != after:
		_commit(title, before, after)
		changed.emit()


## Changes to the scene between begin_gesture() and end_gesture(), such as those of a drag, become
## one action in the history.
func begin_gesture() -> void:
	_in_gesture = true
	_text_before_gesture = scene.document


func is_in_gesture() -> bool:
	return _in_gesture


func end_gesture(title: String) -> void:
	if _in_gesture:
		_in_gesture = false
		_commit(title, _text_before_gesture, scene.document)
		changed.emit()


func _commit(title: String, before: String, after: String) -> void:
	if before != after:
		_history.commit(title, scene, before, after)


func _on_changed() -> void:
	if not _is_changing:
		changed.emit()


func _on_entries_changed(names: PackedStringArray) -> void:
	entries_changed.emit(names)
