extends Control
## Draws handles over the view.

const HandleOverlay := preload("res://addons/ga_godot/playground/view/handle_overlay.gd")
const ViewPointer := preload("res://addons/ga_godot/playground/view/view_pointer.gd")

var _camera: Camera3D
var _pointer: ViewPointer


func show_pointer(pointer: ViewPointer, camera: Camera3D) -> void:
	_pointer = pointer
	_camera = camera
	_pointer.redraw_needed.connect(queue_redraw)
	queue_redraw()


func _draw() -> void:
	if _pointer != null:
		HandleOverlay.draw(self, _camera, _pointer)
