@tool
extends VBoxContainer
## The row of one interpolation mode: its toggle and color, the pose at t, and the deviation from
## the screw path.

const PlaygroundStyle := preload("../theme/playground_style.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabSettings := preload("lab_settings.gd")
const LabText := preload("lab_text.gd")
const Modes := preload("interpolation_modes.gd")

const SWATCH := Vector2(4.0, 16.0)
const INDENT := 14.0
const DIMMED := Color(1, 1, 1, 0.65)
const FAINT := Color(1, 1, 1, 0.35)

var _lab: InterpolationLab
var _mode: MultivectorLerp.Mode
var _toggle := CheckBox.new()
var _indent := MarginContainer.new()
var _message := Label.new()
var _deviation := ""
var _width := 0.0


func _init(lab: InterpolationLab, mode: MultivectorLerp.Mode) -> void:
	_lab = lab
	_mode = mode
	name = Modes.TITLES[mode]
	add_theme_constant_override(&"separation", 0)
	_toggle.name = "Toggle"
	_toggle.text = Modes.TITLES[mode]
	_toggle.tooltip_text = Modes.DESCRIPTIONS[mode] + "."
	_toggle.toggled.connect(func(on: bool) -> void: _lab.set_setting(LabSettings.MODES[_mode], on))
	var line := HBoxContainer.new()
	line.add_child(_make_swatch(Modes.COLORS[mode]))
	line.add_child(_toggle)
	add_child(line)
	_indent.add_theme_constant_override(&"margin_left", roundi(INDENT * PlaygroundStyle.scale()))
	add_child(_indent)
	_message.name = "Message"
	_message.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_message.modulate = DIMMED
	_message.mouse_filter = Control.MOUSE_FILTER_PASS
	_message.resized.connect(_on_resized)
	_indent.add_child(_message)


func refresh() -> void:
	var is_shown := _lab.shows_mode(_mode)
	_toggle.set_pressed_no_signal(is_shown)
	# Hidden modes keep their text, so that the layout does not move under the mouse.
	_message.modulate = DIMMED if is_shown else FAINT
	_measure()
	refresh_t()


func refresh_t() -> void:
	_message.text = LabText.pose(_lab.get_pose(_mode)) + _deviation
	# The height only grows, so that the layout does not jump while t moves.
	_message.custom_minimum_size.y = _message.size.y


func _on_resized() -> void:
	if _message.size.x != _width:
		_width = _message.size.x
		_message.custom_minimum_size.y = 0.0


func _measure() -> void:
	if _mode == MultivectorLerp.SCREW:
		_deviation = ""
		return
	_deviation = "\n" + LabText.deviation(_lab.measure(_mode, MultivectorLerp.SCREW))
	var lever_arm: float = _lab.get_setting(&"lever_arm")
	_message.tooltip_text = (
		(
			"The pose at t, and the largest deviation from the screw path, measured at the points of the"
			+ " body that are %s from its origin."
		)
		% LabText.length(lever_arm)
	)


static func _make_swatch(color: Color) -> Control:
	var swatch := ColorRect.new()
	swatch.color = color
	swatch.custom_minimum_size = SWATCH * PlaygroundStyle.scale()
	swatch.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	swatch.mouse_filter = Control.MOUSE_FILTER_IGNORE
	return swatch
