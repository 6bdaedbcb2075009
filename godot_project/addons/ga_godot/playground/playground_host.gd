@tool
extends RefCounted
## The environment of the panel: the editor or a running game.

const EditHistory := preload("document/edit_history.gd")
const NumberField := preload("panel/number_field.gd")
const ViewPoint := preload("picture/view_point.gd")

var history: EditHistory


func make_number_field(_step: float) -> NumberField:
	assert(false, "make_number_field() is not overridden")
	return null


## A dialog for scene files.
func make_file_dialog() -> FileDialog:
	assert(false, "make_file_dialog() is not overridden")
	return null


## Shows a warning to the user.
func warn(_message: String) -> void:
	assert(false, "warn() is not overridden")


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
