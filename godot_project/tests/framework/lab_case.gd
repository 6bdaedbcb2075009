extends "res://tests/framework/test_case.gd"
## The base class of tests that use the interpolation lab in the playground's panel by mouse and
## keyboard.

const GameHost := preload("res://addons/ga_godot/playground/game_host.gd")
const PlaygroundPanel := preload("res://addons/ga_godot/playground/playground_panel.gd")
const InterpolationLab := preload("res://addons/ga_godot/playground/lab/interpolation_lab.gd")
const LabPanel := preload("res://addons/ga_godot/playground/lab/lab_panel.gd")

const A := "motor(e1 + e2, rotor(e3, 1), 2)"
const B := "motor(3 e3, rotor(e1 + e2, 2), 0.7)"
const SIZE := Vector2i(250, 1000)

var _host := GameHost.new()
var _view := SubViewport.new()
var _panel: PlaygroundPanel
var _lab: InterpolationLab
var _lab_panel: LabPanel


func _open(entries: Dictionary, unfolded := true) -> void:
	_panel = PlaygroundPanel.new(_host)
	_panel.size = SIZE
	_view.size = SIZE
	_view.add_child(_panel)
	add_node(_view)
	_lab = _panel.lab
	_lab_panel = _panel.find_child("Interpolation", true, false)
	var scene := GAScene.new()
	for entry: String in entries:
		scene.add_entry(entry, entries[entry] as String)
	_panel.document.show_scene(scene, "")
	if unfolded:
		_lab_panel.expand()


func _scene() -> GAScene:
	return _panel.document.scene


func _setting(key: String) -> Variant:
	return _scene().get_scene_attribute("interpolation/" + key)


func _expect_kept(t: float) -> void:
	expect_near(_lab.t, t, 1e-9, "t")
	var expected := MultivectorLerp.interpolate(
		_scene().get_value("A"), _scene().get_value("B"), t, MultivectorLerp.SCREW
	)
	expect_equal(
		_scene().get_value("m1").coefficients, expected.coefficients, "added pose at %s" % t
	)


func _button(title: String) -> Button:
	return _lab_panel.find_child(title, true, false)


func _choice(title: String) -> OptionButton:
	return _lab_panel.find_child(title, true, false)


func _choose(title: String, entry: String) -> void:
	var choice := _choice(title)
	for index in choice.item_count:
		if choice.get_item_text(index) == entry:
			choice.select(index)
			choice.item_selected.emit(index)
			return


## The text about the poses.
func _message() -> String:
	var label: Label = _lab_panel.find_child("Ends", true, false).find_child("Message", true, false)
	return label.text if label.visible else ""


func _click(control: Control) -> void:
	await _drag(control.get_global_rect().get_center(), control.get_global_rect().get_center())
	await wait_frames(8)


func _drag(from: Vector2, to: Vector2) -> void:
	for step in 3:
		var place := from if step == 0 else to
		var motion := InputEventMouseMotion.new()
		motion.position = place
		motion.global_position = place
		motion.button_mask = MOUSE_BUTTON_MASK_LEFT if step == 1 else 0 as MouseButtonMask
		if step < 2:
			_view.push_input(motion)
		if step != 1:
			var click := InputEventMouseButton.new()
			click.position = place
			click.global_position = place
			click.button_index = MOUSE_BUTTON_LEFT
			click.pressed = step == 0
			_view.push_input(click)
		await wait_frames(1)
