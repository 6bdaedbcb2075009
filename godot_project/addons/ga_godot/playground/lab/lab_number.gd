@tool
extends MarginContainer
## A field for a numeric setting of the lab.

const NumberField := preload("../panel/number_field.gd")
const PlaygroundHost := preload("../playground_host.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabSettings := preload("lab_settings.gd")

const WIDTH := 56.0
const LETTER_WIDTH := 8.0

var _lab: InterpolationLab
var _key: StringName
var _field: NumberField


func _init(
	lab: InterpolationLab,
	host: PlaygroundHost,
	key: StringName,
	label: String,
	step: float,
	hint: String
) -> void:
	name = String(key).to_pascal_case()
	_lab = lab
	_key = key
	_field = host.make_number_field(step)
	_field.show_label(label)
	_field.tooltip_text = hint
	_field.custom_minimum_size.x = (WIDTH + LETTER_WIDTH * label.length()) * PlaygroundStyle.scale()
	_field.edited.connect(_on_edited)
	_field.grabbed.connect(_lab.document.begin_gesture)
	_field.ungrabbed.connect(func() -> void: _lab.document.end_gesture(_get_action_title()))
	add_child(_field)


func refresh() -> void:
	_field.show_number(_lab.get_setting(_key) as float)


func _on_edited(number: float) -> void:
	var allowed := LabSettings.clamped(_key, number)
	if _lab.document.is_in_gesture():
		LabSettings.write(_lab.document.scene, _key, allowed)
	else:
		_lab.set_settings(_get_action_title(), {_key: allowed})
	if allowed != number:
		refresh()


func _get_action_title() -> String:
	return "Set Interpolation %s" % String(_key).capitalize()
