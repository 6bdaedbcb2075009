@tool
extends Container
## A column whose scroll containers get the height of their contents if there is room; the part with
## SIZE_EXPAND gets the rest. The minimum height is independent of the current layout, so that the
## column can shrink again.

const CappedScroll := preload("capped_scroll.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")

const SEPARATION := 4.0
## The share of the first scroll container if there is not enough room for all.
const FIRST_SHARE := 0.4


func _notification(what: int) -> void:
	if what == NOTIFICATION_SORT_CHILDREN:
		_lay_out()


func _get_minimum_size() -> Vector2:
	var minimum := Vector2(0.0, -_separation())
	for part in _get_parts():
		var needed := part.get_combined_minimum_size()
		minimum = Vector2(maxf(minimum.x, needed.x), minimum.y + needed.y + _separation())
	return minimum.max(Vector2.ZERO)


func _lay_out() -> void:
	var parts := _get_parts()
	var room := maxf(size.y - get_combined_minimum_size().y, 0.0)
	var extras := _distribute(parts, room)
	for extra: float in extras.values():
		room -= extra
	for child in get_children():
		# Otherwise it would stay where it was and block the mouse.
		if child is CappedScroll and not parts.has(child as Control):
			fit_child_in_rect(child as Control, Rect2())
	var top := 0.0
	for part in parts:
		var height := part.get_combined_minimum_size().y
		height += extras.get(part, room if part.size_flags_vertical & SIZE_EXPAND else 0.0)
		fit_child_in_rect(part, Rect2(0.0, top, size.x, height))
		top += height + _separation()


## The height of each scroll container beyond its minimum.
func _distribute(parts: Array[Control], room: float) -> Dictionary[Control, float]:
	var requested: Dictionary[Control, float] = {}
	var all := 0.0
	for part in parts:
		if part is CappedScroll:
			requested[part] = (
				(part as CappedScroll).get_content_height() - part.get_combined_minimum_size().y
			)
			all += requested[part]
	if all <= room:
		return requested
	var rest := room
	for part: Control in requested:
		var others := all - requested[part]
		requested[part] = minf(
			requested[part],
			maxf(rest - others, room * FIRST_SHARE if part == requested.keys()[0] else rest)
		)
		rest -= requested[part]
	return requested


func _get_parts() -> Array[Control]:
	var parts: Array[Control] = []
	for child in get_children():
		var is_empty := (
			child is CappedScroll and (child as CappedScroll).get_content_height() == 0.0
		)
		if child is Control and (child as Control).visible and not is_empty:
			parts.append(child)
	return parts


func _separation() -> float:
	return SEPARATION * PlaygroundStyle.scale()
