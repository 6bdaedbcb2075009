extends Button
## A button of the mode list: color, name and description.

const Modes := preload("res://addons/ga_godot/playground/lab/interpolation_modes.gd")

const HEIGHT := 52
const MARGIN := 6
const SWATCH_SIZE := Vector2(4, 28)


func _init(mode := 0, group: ButtonGroup = null) -> void:
	name = Modes.TITLES[mode]
	toggle_mode = true
	button_group = group
	custom_minimum_size.y = HEIGHT

	var row := HBoxContainer.new()
	row.set_anchors_and_offsets_preset(
		Control.PRESET_FULL_RECT, Control.PRESET_MODE_MINSIZE, MARGIN
	)
	row.add_theme_constant_override(&"separation", 8)
	row.mouse_filter = Control.MOUSE_FILTER_IGNORE
	add_child(row)

	var swatch := ColorRect.new()
	swatch.color = Modes.COLORS[mode]
	swatch.custom_minimum_size = SWATCH_SIZE
	swatch.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	swatch.mouse_filter = Control.MOUSE_FILTER_IGNORE
	row.add_child(swatch)

	var lines := VBoxContainer.new()
	lines.alignment = BoxContainer.ALIGNMENT_CENTER
	lines.add_theme_constant_override(&"separation", -3)
	lines.mouse_filter = Control.MOUSE_FILTER_IGNORE
	row.add_child(lines)
	lines.add_child(_make_line(Modes.TITLES[mode], &"Label"))
	lines.add_child(_make_line(Modes.DESCRIPTIONS[mode], &"CaptionLabel"))


func _make_line(text: String, variation: StringName) -> Label:
	var label := Label.new()
	label.text = text
	label.theme_type_variation = variation
	return label
