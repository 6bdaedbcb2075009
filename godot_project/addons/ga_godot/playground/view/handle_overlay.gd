@tool
extends RefCounted
## Draws over the view: the handles, the value that is being dragged, and where a click adds an
## object.

const ClickAdding := preload("click_adding.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")
const ViewHandle := preload("view_handle.gd")
const ViewPointer := preload("view_pointer.gd")

## Sizes in pixels.
const DISC := 4.5
const RIM := 1.5
const HOVERED := 1.35
const FILL := Color(1.0, 0.45, 0.35)
const HOVERED_FILL := Color(1.0, 0.85, 0.4)
const RIM_COLOR := Color(1, 1, 1, 0.95)
const SHADE := Color(0, 0, 0, 0.45)
const STEM := Color(1, 1, 1, 0.75)
const PANEL := Color(0.06, 0.07, 0.09, 0.82)
const MARGIN := Vector2(6, 3)
const TEXT_OFFSET := Vector2(16, -16)
const FONT_SIZE := 14


## To be called while the canvas item draws.
static func draw(canvas: CanvasItem, camera: Camera3D, pointer: ViewPointer) -> void:
	var handles := pointer.get_handles(camera)
	var scale := PlaygroundStyle.scale()
	for handle: ViewHandle in handles:
		if handle.is_visible and handle.stem != handle.place:
			canvas.draw_line(handle.stem, handle.place, SHADE, 3.0 * scale, true)
			canvas.draw_line(handle.stem, handle.place, STEM, 1.2 * scale, true)
	for handle: ViewHandle in handles:
		if handle.is_visible:
			_draw_disc(canvas, handle.place, _is_active(handle, pointer), scale)
			if pointer.is_dragging() and handle.is_same(pointer.get_drag().start):
				_draw_text(
					canvas,
					camera.get_viewport().get_visible_rect(),
					handle.place,
					_words(handle),
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


static func _draw_disc(canvas: CanvasItem, place: Vector2, is_active: bool, scale: float) -> void:
	var radius := DISC * scale * (HOVERED if is_active else 1.0)
	canvas.draw_circle(place, radius + 2.0 * RIM * scale, SHADE, true, -1.0, true)
	canvas.draw_circle(place, radius + RIM * scale, RIM_COLOR, true, -1.0, true)
	canvas.draw_circle(place, radius, HOVERED_FILL if is_active else FILL, true, -1.0, true)


# "radius 1.5", "(1, 2, 0)", "angle 90°"
static func _words(handle: ViewHandle) -> String:
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
	canvas: CanvasItem, bounds: Rect2, place: Vector2, words: String, scale: float
) -> void:
	if words.is_empty():
		return
	var font := ThemeDB.fallback_font
	var font_size := roundi(FONT_SIZE * scale)
	var size := font.get_string_size(words, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size)
	var corner := place + TEXT_OFFSET * scale - Vector2(0, size.y)
	# Keeps the text inside the view, to the left of the handle if there is no room to the right.
	var room := bounds.size - size - MARGIN * scale
	corner.x = corner.x if corner.x < room.x else place.x - TEXT_OFFSET.x * scale - size.x
	corner = corner.clamp(MARGIN * scale, room.max(MARGIN * scale))
	canvas.draw_rect(Rect2(corner - MARGIN * scale, size + 2.0 * MARGIN * scale), PANEL)
	canvas.draw_string(
		font,
		corner + Vector2(0, font.get_ascent(font_size)),
		words,
		HORIZONTAL_ALIGNMENT_LEFT,
		-1,
		font_size
	)


# A ring on the surface where a click adds an object.
static func _draw_target(
	canvas: CanvasItem, camera: Camera3D, pointer: ViewPointer, scale: float
) -> void:
	var found := ClickAdding.find_place(pointer.drawing, camera, pointer.mouse)
	var space := pointer.drawing.global_transform
	var place := space * found["place"]
	var normal := (space.basis * found["normal"]).normalized()
	var side := normal.cross(Vector3.RIGHT if absf(normal.x) < 0.9 else Vector3.UP).normalized()
	var radius := 12.0 * scale * ViewHandle.ViewScale.pixel(camera, place)
	var ring := PackedVector2Array()
	for index in 33:
		var edge := place + side.rotated(normal, TAU * index / 32.0) * radius
		if camera.is_position_behind(edge):
			return
		ring.append(camera.unproject_position(edge))
	canvas.draw_polyline(ring, SHADE, 4.0 * scale, true)
	canvas.draw_polyline(ring, HOVERED_FILL, 1.6 * scale, true)
	canvas.draw_circle(
		camera.unproject_position(place), 2.5 * scale, HOVERED_FILL, true, -1.0, true
	)
