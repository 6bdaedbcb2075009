extends HBoxContainer
## A caption, a slider and its value as text.

## Emitted when the player moves the slider, not by [method show_value].
signal moved(value: float)

const CAPTION_WIDTH := 62
const VALUE_WIDTH := 52

var _slider := HSlider.new()
var _value := Label.new()
var _format: String


## [param format] formats the value.
func _init(
	caption: String, min_value: float, max_value: float, step: float, format: String
) -> void:
	_format = format
	add_theme_constant_override(&"separation", 8)
	var label := Label.new()
	label.text = caption
	label.theme_type_variation = &"CaptionLabel"
	label.custom_minimum_size.x = CAPTION_WIDTH
	add_child(label)
	_slider.min_value = min_value
	_slider.max_value = max_value
	_slider.step = step
	_slider.focus_mode = Control.FOCUS_NONE
	_slider.scrollable = false
	_slider.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_slider.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	_slider.value_changed.connect(_on_value_changed)
	add_child(_slider)
	_value.theme_type_variation = &"CaptionLabel"
	_value.custom_minimum_size.x = VALUE_WIDTH
	_value.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	add_child(_value)
	_show()


func get_value() -> float:
	return _slider.value


func show_value(value: float) -> void:
	_slider.set_value_no_signal(value)
	_show()


func _on_value_changed(value: float) -> void:
	_show()
	moved.emit(value)


func _show() -> void:
	_value.text = _format % _slider.value
