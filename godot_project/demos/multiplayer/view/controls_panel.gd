extends VBoxContainer
## Controls that the player can change while the scene runs: network impairments, tolerance and
## mode.

## Emitted when the player changes the network impairments.
signal conditions_changed(conditions: LineConditions)
## Emitted when the player changes tolerance, in meters, or mode; not by [method show_tuning].
signal tuning_requested(tolerance: float, mode: MultivectorLerp.Mode)

const LineConditions := preload("../network/line_conditions.gd")
const SliderRow := preload("slider_row.gd")

const MODE_TITLES: Dictionary[String, MultivectorLerp.Mode] = {
	"Linear": MultivectorLerp.LINEAR,
	"Screw": MultivectorLerp.SCREW,
	"Separate": MultivectorLerp.SEPARATE,
}
const WIDTH := 250
## Seconds between two requests while a slider is dragged.
const REQUEST_INTERVAL := 0.1

var _conditions := LineConditions.new()
var _loss := SliderRow.new("Loss", 0.0, 50.0, 1.0, "%d%%")
var _delay := SliderRow.new("Delay", 0.0, 200.0, 5.0, "%d ms")
var _jitter := SliderRow.new("Jitter", 0.0, 200.0, 5.0, "%d ms")
var _tolerance := SliderRow.new("Tolerance", 1.0, 50.0, 0.5, "%.1f mm")
var _modes: Array[Button] = []
var _mode := MultivectorLerp.SEPARATE
var _has_request := false
var _next_request := 0.0


func _init() -> void:
	custom_minimum_size.x = WIDTH
	add_theme_constant_override(&"separation", 4)
	_add_heading("Network (Each Direction)")
	for row: SliderRow in [_loss, _delay, _jitter]:
		row.moved.connect(_on_network_moved)
		add_child(row)
	_add_gap()
	_add_heading("Motors (All Players)")
	_tolerance.moved.connect(_on_tuning_moved)
	add_child(_tolerance)
	_add_modes()


func _process(delta: float) -> void:
	_next_request -= delta
	if _has_request and _next_request <= 0.0:
		_has_request = false
		_next_request = REQUEST_INTERVAL
		tuning_requested.emit(_tolerance.get_value() / 1000.0, _mode)


func show_conditions(conditions: LineConditions) -> void:
	_conditions = conditions
	_loss.show_value(conditions.loss * 100.0)
	_delay.show_value(conditions.delay * 1000.0)
	_jitter.show_value(conditions.jitter * 1000.0)


func show_tuning(tolerance: float, mode: MultivectorLerp.Mode) -> void:
	if not _has_request:
		_tolerance.show_value(tolerance * 1000.0)
		_mode = mode
		for other: int in _modes.size():
			_modes[other].set_pressed_no_signal(other == mode)


func _on_network_moved(_value: float) -> void:
	var conditions := LineConditions.new()
	conditions.burst = _conditions.burst
	conditions.reorder = _conditions.reorder
	conditions.duplicate = _conditions.duplicate
	conditions.rate = _conditions.rate
	conditions.loss = _loss.get_value() / 100.0
	conditions.delay = _delay.get_value() / 1000.0
	conditions.jitter = _jitter.get_value() / 1000.0
	_conditions = conditions
	conditions_changed.emit(conditions)


func _on_tuning_moved(_value: float) -> void:
	_has_request = true


func _on_mode_pressed(mode: MultivectorLerp.Mode) -> void:
	_mode = mode
	_has_request = true


func _add_modes() -> void:
	var row := HBoxContainer.new()
	row.add_theme_constant_override(&"separation", 4)
	var group := ButtonGroup.new()
	for title: String in MODE_TITLES:
		var button := Button.new()
		button.text = title
		button.toggle_mode = true
		button.button_group = group
		button.focus_mode = Control.FOCUS_NONE
		button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		button.add_theme_font_size_override(&"font_size", 12)
		button.pressed.connect(_on_mode_pressed.bind(MODE_TITLES[title]))
		row.add_child(button)
		_modes.append(button)
	add_child(row)


func _add_heading(text: String) -> void:
	var label := Label.new()
	label.text = text
	add_child(label)


func _add_gap() -> void:
	var gap := Control.new()
	gap.custom_minimum_size.y = 4
	add_child(gap)
