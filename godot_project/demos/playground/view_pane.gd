extends Control
## Shows a SubViewport, its child, in the pixels of the screen, and hands it what the mouse does here. Places in the
## viewport are those of this control.

## Asked before the viewport with each event; true if it was used.
var first_listener := Callable()

@onready var viewport: SubViewport = $Viewport


func _ready() -> void:
	focus_mode = Control.FOCUS_CLICK
	clip_contents = true
	resized.connect(_fit)
	get_viewport().size_changed.connect(_fit)
	_fit()


func _draw() -> void:
	draw_texture_rect(viewport.get_texture(), Rect2(Vector2.ZERO, size), false)


func _gui_input(event: InputEvent) -> void:
	var is_used: bool = first_listener.call(event) if first_listener.is_valid() else false
	if not is_used:
		viewport.push_input(event, true)
	if event is InputEventMouseButton:
		accept_event()


func _fit() -> void:
	var pixels := Vector2i((size * get_viewport().get_final_transform().get_scale()).round()).max(
		Vector2i.ONE * 2
	)
	viewport.size = pixels
	viewport.size_2d_override = Vector2i(size).max(Vector2i.ONE * 2)
	queue_redraw()
