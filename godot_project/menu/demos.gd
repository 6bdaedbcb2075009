extends RefCounted
## The demos in the order of the menu.
## The demo NAME is the scene res://demos/NAME/NAME.tscn; `-- --demo=NAME` opens it directly.

const Demos := preload("res://menu/demos.gd")

var name: StringName
var title: String
## One line for the menu.
var description: String


func _init(p_name: StringName, p_title: String, p_description: String) -> void:
	name = p_name
	title = p_title
	description = p_description


func get_scene_path() -> String:
	return "res://demos/%s/%s.tscn" % [name, name]


static func list() -> Array[Demos]:
	return [
		Demos.new(
			&"interpolation",
			"Interpolation",
			"A cube between two poses: linear, screw and separate paths side by side."
		),
		Demos.new(
			&"multiplayer",
			"Multiplayer",
			"A physics server replicates 250 cubes as quantized motors. Push them around."
		),
		Demos.new(
			&"playground",
			"Playground",
			"Points, circles, spheres and motors that depend on each other. Build and drag."
		),
	]


## Returns the demo of that name, or null.
static func find(demo_name: StringName) -> Demos:
	for demo in list():
		if demo.name == demo_name:
			return demo
	return null
