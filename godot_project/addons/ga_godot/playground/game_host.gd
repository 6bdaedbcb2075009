@tool
extends "playground_host.gd"
## Hosts the panel in a running game, with its own undo history and files in user://.

## Emitted to show a warning to the user.
signal warned(message: String)

const DragField := preload("panel/drag_field.gd")
const OwnHistory := preload("document/own_history.gd")

## The camera of the view; null until the view exists.
var camera: Camera3D
## Distance from the camera to its pivot, in meters.
var camera_distance := 1.0
var background := ViewPoint.DEFAULT_BACKGROUND
## The same object as `history`, with the type that provides undo() and redo().
var own_history := OwnHistory.new()


func _init() -> void:
	history = own_history


func make_number_field(step: float) -> NumberField:
	return DragField.new(step)


func make_file_dialog() -> FileDialog:
	var files := FileDialog.new()
	files.access = FileDialog.ACCESS_USERDATA
	return files


func warn(message: String) -> void:
	warned.emit(message)


func make_view_point() -> ViewPoint:
	if camera == null:
		return null
	var view := ViewPoint.of_camera(camera, camera_distance)
	view.background = background
	return view


func get_view_size() -> Vector2i:
	return (
		(camera.get_viewport() as SubViewport).size
		if camera.get_viewport() is SubViewport
		else camera.get_window().size
	)
