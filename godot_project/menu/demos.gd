extends RefCounted
## The demos that the start scene offers, in the order of the menu.
## A demo called NAME is the scene res://demos/NAME/NAME.tscn, started directly with `-- --demo=NAME`.

const Demos := preload("res://menu/demos.gd")

var name: StringName
var title: String
## One line for the menu: what there is to see.
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
			"One cube between two poses: linear, screw and separate paths side by side."
		),
		Demos.new(
			&"multiplayer",
			"Multiplayer",
			"A physics server replicates 250 cubes as quantised motors; push them around."
		),
		Demos.new(
			&"playground",
			"Playground",
			"Points, circles, spheres and motors that follow each other: build and drag."
		),
	]


## The demo of that name, or null.
static func find(wanted: StringName) -> Demos:
	for demo in list():
		if demo.name == wanted:
			return demo
	return null
