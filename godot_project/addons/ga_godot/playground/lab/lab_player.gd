@tool
extends HBoxContainer
## The slider of t, the play button, and the repeat mode.

const PlaygroundStyle := preload("../theme/playground_style.gd")
const InterpolationLab := preload("interpolation_lab.gd")
const LabPlayback := preload("lab_playback.gd")

const STEP := 0.001
const VALUE_WIDTH := 44.0
const SLIDER_WIDTH := 60.0
const REPEAT_ICONS: Dictionary[String, StringName] = {
	LabPlayback.PING_PONG: &"PingPongLoop",
	LabPlayback.LOOP: &"Loop",
	LabPlayback.ONCE: &"Stop",
}

var _lab: InterpolationLab
var _play := Button.new()
var _slider := HSlider.new()
var _value := Label.new()
var _repeat := Button.new()
var _is_dragged := false


func _init(lab: InterpolationLab) -> void:
	name = "Player"
	_lab = lab
	_prepare_button(_play, "Play", _on_play_pressed)
	_slider.name = "Slider"
	_slider.max_value = 1.0
	_slider.step = STEP
	_slider.scrollable = false
	_slider.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_slider.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	_slider.custom_minimum_size.x = SLIDER_WIDTH * PlaygroundStyle.scale()
	_slider.drag_started.connect(_on_drag_started)
	_slider.drag_ended.connect(_on_drag_ended)
	_slider.value_changed.connect(_on_value_changed)
	_value.name = "Value"
	_value.custom_minimum_size.x = VALUE_WIDTH * PlaygroundStyle.scale()
	_value.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	_prepare_button(_repeat, "Repeat", _on_repeat_pressed)
	for part: Control in [_play, _slider, _value, _repeat]:
		add_child(part)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		refresh()


func refresh() -> void:
	var repeat: String = _lab.get_setting(&"repeat")
	_repeat.icon = get_theme_icon(REPEAT_ICONS[repeat], &"EditorIcons")
	_repeat.tooltip_text = (
		"Repeat mode: %s. Click to change it." % LabPlayback.TITLES[repeat].to_lower()
	)
	refresh_t()


func refresh_t() -> void:
	var is_playing := _lab.is_playing()
	_play.icon = get_theme_icon(&"Pause" if is_playing else &"Play", &"EditorIcons")
	_play.tooltip_text = "Pause." if is_playing else "Play from one pose to the other."
	_slider.set_value_no_signal(_lab.t)
	_value.text = "%.3f" % _lab.t
	var entry := _lab.get_t_entry()
	_slider.tooltip_text = (
		"t, from 0 at the first pose to 1 at the second."
		if entry.is_empty()
		else "t, the value of the entry %s." % entry
	)


func _prepare_button(button: Button, title: String, act: Callable) -> void:
	button.name = title
	button.theme_type_variation = &"FlatButton"
	button.focus_mode = Control.FOCUS_NONE
	button.pressed.connect(act)


func _on_play_pressed() -> void:
	if _lab.is_playing():
		_lab.stop()
	else:
		_lab.play()


func _on_repeat_pressed() -> void:
	var modes := LabPlayback.TITLES.keys()
	_lab.set_setting(&"repeat", modes[(modes.find(_lab.get_setting(&"repeat")) + 1) % modes.size()])


func _on_drag_started() -> void:
	_is_dragged = true
	_lab.begin_move()


func _on_drag_ended(_has_changed: bool) -> void:
	_is_dragged = false
	_lab.end_move()


func _on_value_changed(t: float) -> void:
	if _is_dragged:
		_lab.move(t)
	else:
		# Each step with the keyboard is one action in the history.
		_lab.begin_move()
		_lab.move(t)
		_lab.end_move()
