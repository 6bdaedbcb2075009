@tool
extends ScrollContainer
## As high as its content, up to a limit; what is higher is scrolled. Hidden while the content has no height.

signal wanted_height_changed

var content: Control
var cap := 0.0: set = set_cap


func _init(p_content: Control) -> void:
	content = p_content
	content.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	follow_focus = true
	add_child(content)
	content.minimum_size_changed.connect(_on_content_changed)
	_fit()


func set_cap(value: float) -> void:
	cap = value
	_fit()


func get_wanted_height() -> float:
	return content.get_combined_minimum_size().y


func _on_content_changed() -> void:
	_fit()
	wanted_height_changed.emit()


func _fit() -> void:
	var height := get_wanted_height()
	visible = height > 0.0
	custom_minimum_size.y = minf(height, cap)
