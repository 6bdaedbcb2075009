@tool
extends MarginContainer
## A labeled number that the user can drag or type.

## Emitted when the user changes the number.
signal edited(number: float)
## Emitted when the user starts and stops dragging.
signal grabbed
signal ungrabbed


func get_number() -> float:
	assert(false, "get_number() is not overridden")
	return 0.0


## Sets the displayed number without emitting `edited`.
func show_number(_number: float) -> void:
	assert(false, "show_number() is not overridden")


func show_label(_text: String) -> void:
	assert(false, "show_label() is not overridden")


func set_read_only(_read_only: bool) -> void:
	assert(false, "set_read_only() is not overridden")


func is_read_only() -> bool:
	assert(false, "is_read_only() is not overridden")
	return false
