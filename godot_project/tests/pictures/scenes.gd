extends RefCounted
## The pictures that are compared: how each scene is brought into one state that never changes.

const Interpolation := preload("res://demos/interpolation/interpolation.gd")

const MENU := "res://menu/menu.tscn"
const INTERPOLATION := "res://demos/interpolation/interpolation.tscn"
const FACTOR := 0.4


## Makes each picture's scene, by the picture's name.
static func list() -> Dictionary[String, Callable]:
	return {
		"menu": open.bind(MENU),
		"interpolation": interpolation,
		"interpolation_paths": interpolation.bind(0, MultivectorLerp.SCREW, false),
		"interpolation_half_turn": interpolation.bind(1, MultivectorLerp.LINEAR, false),
		"interpolation_door": interpolation.bind(2, MultivectorLerp.SEPARATE, false),
	}


static func open(parent: Node, path: String) -> Node:
	var packed: PackedScene = load(path)
	var scene := packed.instantiate()
	parent.add_child(scene)
	return scene


static func interpolation(parent: Node, preset := 0, mode := MultivectorLerp.SCREW, with_panels := true) -> Interpolation:
	var demo: Interpolation = open(parent, INTERPOLATION)
	demo.choose_preset(preset)
	demo.choose_mode(mode)
	demo.set_factor(FACTOR)
	demo.show_panels(with_panels)
	return demo
