@tool
@abstract
extends MarginContainer
## A labeled number that the user can drag or type.

## Emitted when the user changes the number.
signal edited(number: float)
## Emitted when the user starts and stops dragging.
signal grabbed
signal ungrabbed

@abstract func get_number() -> float

## Sets the displayed number without emitting `edited`.
@abstract func show_number(number: float) -> void

@abstract func show_label(text: String) -> void

@abstract func set_read_only(read_only: bool) -> void

@abstract func is_read_only() -> bool
