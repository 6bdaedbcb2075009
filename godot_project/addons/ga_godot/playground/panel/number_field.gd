@tool
@abstract
extends MarginContainer
## A labeled number that the user can drag or type.

## The user changed the number.
signal edited(number: float)
## The user started and stopped dragging.
signal grabbed
signal ungrabbed

@abstract func get_number() -> float

## Emits no signal.
@abstract func show_number(number: float) -> void

@abstract func show_label(text: String) -> void

@abstract func set_read_only(read_only: bool) -> void

@abstract func is_read_only() -> bool
