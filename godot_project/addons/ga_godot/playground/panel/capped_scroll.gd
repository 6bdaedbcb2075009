@tool
extends ScrollContainer
## A scroll container that grows to the height of its content if there is room (sharing_column.gd).

const PlaygroundStyle := preload("../theme/playground_style.gd")

const MIN_HEIGHT := 60.0

var content: Control


func _init(p_content: Control) -> void:
	content = p_content
	content.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	follow_focus = true
	add_child(content)
	content.minimum_size_changed.connect(_fit)
	_fit()


func get_content_height() -> float:
	return content.get_combined_minimum_size().y


func _fit() -> void:
	custom_minimum_size.y = minf(get_content_height(), MIN_HEIGHT * PlaygroundStyle.scale())
	var column := get_parent() as Container
	if column != null:
		column.queue_sort()
