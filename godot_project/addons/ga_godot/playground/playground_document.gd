@tool
extends RefCounted
## The scene that the playground shows, where it is saved, and every change to it as one step that can be undone.

## Another scene is shown, or it has another file.
signal scene_switched
## Something of the scene changed; also when it was undone.
signal changed

const EditHistory := preload("edit_history.gd")

## What an expression that is being typed is called meanwhile.
const TYPED := "_typed"
const MAX_NAME_LENGTH := 64

var scene: GAScene
## Of the file; empty if it was never saved.
var path := ""

var _history: EditHistory
var _saved_text := ""
var _text_before_gesture := ""
var _in_gesture := false


func _init(history: EditHistory) -> void:
	_history = history
	show_scene(GAScene.new(), "")


func show_scene(new_scene: GAScene, new_path: String) -> void:
	if scene != null:
		scene.changed.disconnect(_on_changed)
	scene = new_scene
	path = new_path
	_in_gesture = false
	_saved_text = scene.document
	scene.changed.connect(_on_changed)
	scene_switched.emit()
	changed.emit()


func is_unsaved() -> bool:
	return scene.document != _saved_text


## The scene as it was when it was opened or last saved.
func get_saved_text() -> String:
	return _saved_text


func mark_saved(new_path: String) -> void:
	path = new_path
	_saved_text = scene.document
	scene_switched.emit()


## Calls edit with a copy of the scene; what it makes of it is the new state, one step of the history.
func change(title: String, edit: Callable) -> void:
	var copy := copy_scene()
	edit.call(copy)
	_commit(title, scene.document, copy.document)


## Between these two, changes are made on the scene itself, at the rate of a drag; they become one step.
func begin_gesture() -> void:
	_in_gesture = true
	_text_before_gesture = scene.document


func is_in_gesture() -> bool:
	return _in_gesture


func end_gesture(title: String) -> void:
	if _in_gesture:
		_in_gesture = false
		_commit(title, _text_before_gesture, scene.document)


func copy_scene() -> GAScene:
	var copy := GAScene.new()
	copy.document = scene.document
	return copy


## Why the text cannot be the name of a new entry; empty if it can.
func name_error(text: String) -> String:
	if scene.has_entry(text):
		return "There is an entry %s already." % text
	var language := GAScene.new()
	language.add_entry(TYPED, text)
	if text.length() > MAX_NAME_LENGTH or language.get_dependencies(TYPED) != PackedStringArray([text]):
		return "%s cannot be a name: it needs letters, digits and underscores, no digit first, and must not be a constant." % ("This" if text.is_empty() else text)
	return ""


## The scene as it would be with that expression of an entry, or of one more called TYPED.
func preview(text: String, entry := TYPED) -> GAScene:
	var copy := copy_scene()
	if copy.has_entry(entry):
		copy.set_expression(entry, text)
	else:
		copy.add_entry(entry, text)
	return copy


func _commit(title: String, before: String, after: String) -> void:
	if before != after:
		_history.commit(title, scene, before, after)


func _on_changed() -> void:
	changed.emit()
