@tool
extends "../playground/panel/number_field.gd"
## The number field of the editor.

var _slider := EditorSpinSlider.new()


func _init(step: float) -> void:
	_slider.step = step
	_slider.hide_slider = true
	_slider.allow_greater = true
	_slider.allow_lesser = true
	_slider.value_changed.connect(edited.emit)
	_slider.grabbed.connect(grabbed.emit)
	_slider.ungrabbed.connect(ungrabbed.emit)
	# A click without a drag starts typing.
	_slider.value_focus_entered.connect(ungrabbed.emit)
	# Passes mouse events on to this container, which has the tooltip.
	_slider.mouse_filter = Control.MOUSE_FILTER_PASS
	add_child(_slider)


func get_number() -> float:
	return _slider.value


func show_number(number: float) -> void:
	_slider.set_value_no_signal(number)


func show_label(text: String) -> void:
	_slider.label = text


func set_read_only(read_only: bool) -> void:
	_slider.read_only = read_only


func is_read_only() -> bool:
	return _slider.read_only
