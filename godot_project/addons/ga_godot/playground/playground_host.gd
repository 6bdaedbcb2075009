@tool
@abstract
extends RefCounted
## The environment of the panel: the editor or a running game.

const EditHistory := preload("document/edit_history.gd")
const NumberField := preload("panel/number_field.gd")
const ViewPoint := preload("picture/view_point.gd")

var history: EditHistory

@abstract func make_number_field(step: float) -> NumberField

## A dialog for scene files.
@abstract func make_file_dialog() -> FileDialog

## Shows a warning to the user.
@abstract func warn(message: String) -> void


## Called after a file was written.
func on_file_written(_path: String) -> void:
	pass


## Saves the file that the scene is embedded in.
func save_containing_scene(_file: String) -> void:
	pass


func can_create_nodes() -> bool:
	return false


## Adds a node that draws the entry to the edited scene.
func create_node(_scene: GAScene, _entry: String) -> void:
	pass


## The current view of the scene; null if there is none.
func make_view_point() -> ViewPoint:
	return null


## The size of the view in pixels.
func get_view_size() -> Vector2i:
	return Vector2i.ZERO
