extends Control
## Shows its child, a SubViewport, at the resolution of the screen and forwards mouse input to it.
## The viewport uses the coordinates of this control.

## Called with each event before the viewport; returns true if it handled the event.
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
	var is_handled: bool = first_listener.call(event) if first_listener.is_valid() else false
	if not is_handled:
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
