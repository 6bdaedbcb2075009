@tool
@abstract
extends MarginContainer
## A number with a label, which is dragged or typed.

## By a person.
signal edited(number: float)
## Between these two, it is dragged.
signal grabbed
signal ungrabbed

@abstract func get_number() -> float

## Without a signal.
@abstract func show_number(number: float) -> void

@abstract func show_label(text: String) -> void

@abstract func set_read_only(read_only: bool) -> void

@abstract func is_read_only() -> bool
