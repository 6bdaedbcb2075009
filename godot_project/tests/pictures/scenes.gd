extends RefCounted
## The screenshots to compare: brings each scene into a fixed state.

const DrawnObjects := preload("res://tests/pictures/drawn_objects.gd")
const DrawnScene := preload("res://tests/pictures/drawn_scene.gd")
const FoldPanel := preload("res://addons/ga_godot/playground/panel/fold_panel.gd")
const InterpolationLab := preload("res://tests/pictures/interpolation_lab.gd")
const Interpolation := preload("res://demos/interpolation/interpolation.gd")
const Playground := preload("res://demos/playground/playground.gd")

const MENU := "res://menu/menu.tscn"
const INTERPOLATION := "res://demos/interpolation/interpolation.tscn"
const PLAYGROUND := "res://demos/playground/playground.tscn"
const FACTOR := 0.4


## Functions that open the scenes, by the name of the screenshot.
static func list() -> Dictionary[String, Callable]:
	return {
		"menu": open.bind(MENU),
		"interpolation": interpolation,
		"interpolation_paths": interpolation.bind(0, MultivectorLerp.SCREW, false),
		"interpolation_half_turn": interpolation.bind(1, MultivectorLerp.LINEAR, false),
		"interpolation_door": interpolation.bind(2, MultivectorLerp.SEPARATE, false),
		"drawn_objects": drawn_objects.bind(false),
		"drawn_objects_on_light": drawn_objects.bind(true),
		"drawn_scene": drawn_scene,
		"playground": playground.bind(false),
		"playground_on_light": playground.bind(true),
		"interpolation_lab": interpolation_lab.bind("cube"),
		"interpolation_lab_frames": interpolation_lab.bind("frame"),
	}


static func open(parent: Node, path: String) -> Node:
	var packed: PackedScene = load(path)
	var scene := packed.instantiate()
	parent.add_child(scene)
	return scene


static func drawn_objects(parent: Node, light: bool) -> Node:
	var picture := DrawnObjects.make(light)
	parent.add_child(picture)
	return picture


static func drawn_scene(parent: Node) -> Node:
	var picture := DrawnScene.make()
	parent.add_child(picture)
	return picture


static func interpolation_lab(parent: Node, body: String) -> Node:
	var picture := InterpolationLab.make(body)
	parent.add_child(picture)
	return picture


static func interpolation(
	parent: Node, preset := 0, mode := MultivectorLerp.SCREW, with_panels := true
) -> Interpolation:
	var demo: Interpolation = open(parent, INTERPOLATION)
	demo.choose_preset(preset)
	demo.choose_mode(mode)
	demo.set_factor(FACTOR)
	demo.show_panels(with_panels)
	return demo


## With an object selected; with the light theme also with its coefficients.
static func playground(parent: Node, light: bool) -> Playground:
	var packed: PackedScene = load(PLAYGROUND)
	var demo: Playground = packed.instantiate()
	demo.state_path = ""
	parent.add_child(demo)
	demo.set_light(light)
	demo.panel.select("S" if light else "A")
	if light:
		(demo.panel.bottom.get_node(^"Coefficients") as FoldPanel).expand()
	return demo
