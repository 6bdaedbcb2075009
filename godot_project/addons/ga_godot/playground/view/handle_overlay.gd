@tool
extends RefCounted
## Draws over the view: the handles, the value that the user drags, and a ring where a click adds an
## object.

const ClickAdding := preload("click_adding.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const ViewHandle := preload("view_handle.gd")
const ViewPointer := preload("view_pointer.gd")

## Factor for the size of the hovered or dragged handle.
const ACTIVE_SCALE := 1.35
## Sizes in pixels.
const DISC := 4.5
const RIM := 1.5
const FILL := Color(1.0, 0.45, 0.35)
const ACTIVE_FILL := Color(1.0, 0.85, 0.4)
const RIM_COLOR := Color(1, 1, 1, 0.95)
const SHADE := Color(0, 0, 0, 0.45)
const STEM := Color(1, 1, 1, 0.75)
const PANEL := Color(0.06, 0.07, 0.09, 0.82)
const MARGIN := Vector2(6, 3)
const TEXT_OFFSET := Vector2(16, -16)
const FONT_SIZE := 14


## Call this from the canvas item's _draw().
static func draw(canvas: CanvasItem, camera: Camera3D, pointer: ViewPointer) -> void:
	var handles := pointer.get_handles(camera)
	var scale := PlaygroundStyle.scale()
	for handle: ViewHandle in handles:
		if handle.is_visible and handle.stem != handle.position:
			canvas.draw_line(handle.stem, handle.position, SHADE, 3.0 * scale, true)
			canvas.draw_line(handle.stem, handle.position, STEM, 1.2 * scale, true)
	for handle: ViewHandle in handles:
		if handle.is_visible:
			_draw_disc(canvas, handle.position, _is_active(handle, pointer), scale)
			if pointer.is_dragging() and handle.is_same(pointer.get_drag().start):
				_draw_text(
					canvas,
					camera.get_viewport().get_visible_rect(),
					handle.position,
					_get_value_text(handle),
					scale
				)
	if (
		not pointer.adding.is_empty()
		and pointer.mouse.is_finite()
		and pointer.mouse_camera == camera
	):
		_draw_target(canvas, camera, pointer, scale)


static func _is_active(handle: ViewHandle, pointer: ViewPointer) -> bool:
	return handle.is_same(
		pointer.get_drag().start if pointer.is_dragging() else pointer.hovered_handle
	)


static func _draw_disc(
	canvas: CanvasItem, position: Vector2, is_active: bool, scale: float
) -> void:
	var radius := DISC * scale * (ACTIVE_SCALE if is_active else 1.0)
	canvas.draw_circle(position, radius + 2.0 * RIM * scale, SHADE, true, -1.0, true)
	canvas.draw_circle(position, radius + RIM * scale, RIM_COLOR, true, -1.0, true)
	canvas.draw_circle(position, radius, ACTIVE_FILL if is_active else FILL, true, -1.0, true)


# "radius 1.5", "(1, 2, 0)", "angle 90°"
static func _get_value_text(handle: ViewHandle) -> String:
	var parameters := handle.node.scene.get_parameters(handle.node.entry)
	var value: Variant = parameters.get(handle.key())
	if value is Vector3:
		var vector: Vector3 = value
		return "(%s, %s, %s)" % [_number(vector.x), _number(vector.y), _number(vector.z)]
	if value is float:
		var number: float = value
		return (
			"%s %s"
			% [
				handle.key(),
				_number(rad_to_deg(number)) + "°" if handle.key() == "angle" else _number(number)
			]
		)
	return ""


static func _number(value: float) -> String:
	return String.num(snappedf(value, 0.0001) + 0.0, 4).trim_suffix(".0")


static func _draw_text(
	canvas: CanvasItem, bounds: Rect2, position: Vector2, text: String, scale: float
) -> void:
	if text.is_empty():
		return
	var font := ThemeDB.fallback_font
	var font_size := roundi(FONT_SIZE * scale)
	var size := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size)
	var corner := position + TEXT_OFFSET * scale - Vector2(0, size.y)
	# Keeps the text inside the view, to the left of the handle if there is no room to the right.
	var room := bounds.size - size - MARGIN * scale
	corner.x = corner.x if corner.x < room.x else position.x - TEXT_OFFSET.x * scale - size.x
	corner = corner.clamp(MARGIN * scale, room.max(MARGIN * scale))
	canvas.draw_rect(Rect2(corner - MARGIN * scale, size + 2.0 * MARGIN * scale), PANEL)
	canvas.draw_string(
		font,
		corner + Vector2(0, font.get_ascent(font_size)),
		text,
		HORIZONTAL_ALIGNMENT_LEFT,
		-1,
		font_size
	)


# A ring on the surface where a click adds an object.
static func _draw_target(
	canvas: CanvasItem, camera: Camera3D, pointer: ViewPointer, scale: float
) -> void:
	var found := ClickAdding.find_hit(pointer.drawing, camera, pointer.mouse)
	var space := pointer.drawing.global_transform
	var position := space * found["position"]
	var normal := (space.basis * found["normal"]).normalized()
	var side := normal.cross(Vector3.RIGHT if absf(normal.x) < 0.9 else Vector3.UP).normalized()
	var radius := 12.0 * scale * ViewHandle.ViewScale.pixel(camera, position)
	var ring := PackedVector2Array()
	for index in 33:
		var edge := position + side.rotated(normal, TAU * index / 32.0) * radius
		if camera.is_position_behind(edge):
			return
		ring.append(camera.unproject_position(edge))
	canvas.draw_polyline(ring, SHADE, 4.0 * scale, true)
	canvas.draw_polyline(ring, ACTIVE_FILL, 1.6 * scale, true)
	canvas.draw_circle(
		camera.unproject_position(position), 2.5 * scale, ACTIVE_FILL, true, -1.0, true
	)
