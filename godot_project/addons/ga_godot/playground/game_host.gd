@tool
extends "playground_host.gd"
## A running game around the panel: a history of its own, files in user://.

const DragField := preload("drag_field.gd")
const OwnHistory := preload("own_history.gd")

## Something to tell a person.
signal warned(words: String)

## The same as history, with undo and redo.
var own_history := OwnHistory.new()


func _init() -> void:
	history = own_history


func make_number_field(step: float) -> NumberField:
	return DragField.new(step)


func make_file_dialog() -> FileDialog:
	var files := FileDialog.new()
	files.access = FileDialog.ACCESS_USERDATA
	return files


func warn(words: String) -> void:
	warned.emit(words)
