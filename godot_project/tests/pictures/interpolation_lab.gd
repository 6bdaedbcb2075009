extends Node3D
## The panel of the interpolation lab, narrow with the dark theme and wide with the light one,
## beside its drawing.

const InterpolationLabPicture := preload("res://tests/pictures/interpolation_lab.gd")
const GameHost := preload("res://addons/ga_godot/playground/game_host.gd")
const EntryEdits := preload("res://addons/ga_godot/playground/document/entry_edits.gd")
const EntryList := preload("res://addons/ga_godot/playground/entries/entry_list.gd")
const PlaygroundDocument := preload(
	"res://addons/ga_godot/playground/document/playground_document.gd"
)
const PlaygroundTheme := preload("res://addons/ga_godot/playground/theme/playground_theme.gd")
const SceneDrawing := preload("res://addons/ga_godot/playground/view/scene_drawing.gd")
const InterpolationLab := preload("res://addons/ga_godot/playground/lab/interpolation_lab.gd")
const LabDrawing := preload("res://addons/ga_godot/playground/lab/lab_drawing.gd")
const LabPanel := preload("res://addons/ga_godot/playground/lab/lab_panel.gd")

const WIDTHS: Dictionary[bool, int] = {false: 250, true: 400}

var _host := GameHost.new()
var _lists: Array[EntryList] = []


static func make(body: String) -> InterpolationLabPicture:
	var picture := InterpolationLabPicture.new()
	picture._build(body)
	return picture


func _build(body: String) -> void:
	var scene := GAScene.new()
	scene.add_entry("A", "motor(-1.4 e1 + 0.6 e3, rotor(e2, deg(-20)), 0.7)")
	scene.add_entry("B", "motor(1.3 e1 + 1.2 e2 - 0.8 e3, rotor(vector(0.2, 1, 0), deg(150)), 1.6)")
	for entry in scene.get_names():
		scene.set_entry_attribute(entry, "visible", false)
	scene.set_scene_attribute("interpolation/from", "A")
	scene.set_scene_attribute("interpolation/to", "B")
	scene.set_scene_attribute("interpolation/t", 0.4)
	scene.set_scene_attribute("interpolation/body", body)
	var document := PlaygroundDocument.new(_host.history)
	document.show_scene(scene, "")
	var lab := InterpolationLab.new(document)
	var layer := CanvasLayer.new()
	add_child(layer)
	for light: bool in WIDTHS:
		layer.add_child(_make_side(lab, light))
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = PlaygroundTheme.palette(false)[&"view"]
	add_child(world)
	var camera := Camera3D.new()
	camera.fov = 50.0
	camera.look_at_from_position(Vector3(0.6, 3.0, 5.8), Vector3(0.05, 0.7, 0.0))
	# Center the poses between the panels.
	camera.h_offset = 0.65
	add_child(camera)
	var drawing := SceneDrawing.new()
	drawing.scene = scene
	add_child(drawing)
	add_child(LabDrawing.new(lab))


func _make_side(lab: InterpolationLab, light: bool) -> Control:
	var side := PanelContainer.new()
	side.theme = PlaygroundTheme.make(light)
	side.custom_minimum_size.x = WIDTHS[light]
	side.set_anchors_and_offsets_preset(
		Control.PRESET_RIGHT_WIDE if light else Control.PRESET_LEFT_WIDE
	)
	side.grow_horizontal = Control.GROW_DIRECTION_BEGIN if light else Control.GROW_DIRECTION_END
	var list := EntryList.new(lab.document, EntryEdits.new(lab.document))
	_lists.append(list)
	side.add_child(LabPanel.new(lab, list, _host))
	return side


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		for list in _lists:
			list.free()
