@tool
@abstract
extends RefCounted
## What the panel asks of where it stands: the editor, or a running game.

const EditHistory := preload("document/edit_history.gd")
const NumberField := preload("panel/number_field.gd")
const ViewPoint := preload("picture/view_point.gd")

var history: EditHistory

@abstract func make_number_field(step: float) -> NumberField

## For files of a scene.
@abstract func make_file_dialog() -> FileDialog

## Tells a person what went wrong.
@abstract func warn(words: String) -> void


## A file was written.
func note_file(_path: String) -> void:
	pass


## Saves the file that the scene is a part of.
func save_embedding(_file: String) -> void:
	pass


func can_create_nodes() -> bool:
	return false


## Makes the entry a node of the scene that is edited.
func create_node(_scene: GAScene, _entry: String) -> void:
	pass


## How the scene is looked at here; null where there is no view of it.
func make_view_point() -> ViewPoint:
	return null


## In pixels.
func get_view_size() -> Vector2i:
	return Vector2i.ZERO
