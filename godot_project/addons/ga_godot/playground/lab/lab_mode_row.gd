@tool
extends VBoxContainer
## One way between the poses: whether it is drawn, its colour, the pose at t, and how far it is from the screw.

const PlaygroundStyle := preload("../playground_style.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabSettings := preload("lab_settings.gd")
const LabWords := preload("lab_words.gd")
const Modes := preload("interpolation_modes.gd")

const SWATCH := 12
const INDENT := 14.0
const QUIET := Color(1, 1, 1, 0.65)

var _lab: InterpolationLab
var _mode: MultivectorLerp.Mode
var _toggle := CheckBox.new()
var _indent := MarginContainer.new()
var _words := Label.new()
var _deviation := ""


func _init(lab: InterpolationLab, mode: MultivectorLerp.Mode) -> void:
	_lab = lab
	_mode = mode
	name = Modes.TITLES[mode]
	add_theme_constant_override(&"separation", 0)
	_toggle.name = "Toggle"
	_toggle.text = Modes.TITLES[mode]
	_toggle.tooltip_text = Modes.LINES[mode] + "."
	_toggle.icon = _make_swatch(Modes.COLORS[mode])
	_toggle.toggled.connect(func(on: bool) -> void: _lab.set_setting(LabSettings.MODES[_mode], on))
	add_child(_toggle)
	_indent.add_theme_constant_override(&"margin_left", roundi(INDENT * PlaygroundStyle.scale()))
	add_child(_indent)
	_words.name = "Words"
	_words.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_words.modulate = QUIET
	_words.mouse_filter = Control.MOUSE_FILTER_PASS
	_indent.add_child(_words)


func refresh() -> void:
	var is_shown := _lab.shows_mode(_mode)
	_toggle.set_pressed_no_signal(is_shown)
	_indent.visible = is_shown
	if is_shown:
		_measure()
		refresh_moment()


func refresh_moment() -> void:
	if _indent.visible:
		_words.text = LabWords.pose(_lab.get_moment(_mode)) + _deviation


func _measure() -> void:
	if _mode == MultivectorLerp.SCREW:
		_deviation = ""
		return
	_deviation = "\n" + LabWords.deviation(_lab.measure(_mode, MultivectorLerp.SCREW))
	var lever: float = _lab.get_setting(&"lever")
	_words.tooltip_text = "The pose at t, and the largest deviation on the way. The distance is that of a point %s from the body's origin, of all such points the one that fares worst." % LabWords.length(lever)


static func _make_swatch(color: Color) -> Texture2D:
	var side := roundi(SWATCH * PlaygroundStyle.scale())
	var image := Image.create_empty(side, side, false, Image.FORMAT_RGBA8)
	image.fill(color)
	return ImageTexture.create_from_image(image)
