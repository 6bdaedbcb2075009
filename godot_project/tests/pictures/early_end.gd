## Draws a scene and quits after a few frames, while shaders are still compiling in the background.
##
## godot --path godot_project --script res://tests/pictures/early_end.gd
extends SceneTree

const DrawnScene := preload("res://tests/pictures/drawn_scene.gd")

const FRAMES := 6

var _frames := 0


func _initialize() -> void:
	root.add_child(DrawnScene.make())


func _process(_delta: float) -> bool:
	_frames += 1
	return _frames >= FRAMES
