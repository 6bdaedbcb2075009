@tool
extends Container
## Parts below each other. What scrolls gets the height that it wants as long as there is room; the part that expands gets
## the rest. The least height is not that of the moment, so that the column can get lower again.

const CappedScroll := preload("capped_scroll.gd")
const PlaygroundStyle := preload("../theme/playground_style.gd")

const SEPARATION := 4.0
## Of the room, for the first of what scrolls if there is not enough for all.
const FIRST_SHARE := 0.4


func _notification(what: int) -> void:
	if what == NOTIFICATION_SORT_CHILDREN:
		_lay_out()


func _get_minimum_size() -> Vector2:
	var least := Vector2(0.0, -_separation())
	for part in _get_parts():
		var needed := part.get_combined_minimum_size()
		least = Vector2(maxf(least.x, needed.x), least.y + needed.y + _separation())
	return least.max(Vector2.ZERO)


func _lay_out() -> void:
	var parts := _get_parts()
	var room := maxf(size.y - get_combined_minimum_size().y, 0.0)
	var extras := _share_out(parts, room)
	for extra: float in extras.values():
		room -= extra
	for child in get_children():
		# Else it would lie where it was and take the mouse.
		if child is CappedScroll and not parts.has(child as Control):
			fit_child_in_rect(child as Control, Rect2())
	var place := 0.0
	for part in parts:
		var height := part.get_combined_minimum_size().y
		height += extras.get(part, room if part.size_flags_vertical & SIZE_EXPAND else 0.0)
		fit_child_in_rect(part, Rect2(0.0, place, size.x, height))
		place += height + _separation()


## What each of what scrolls gets beside its least height.
func _share_out(parts: Array[Control], room: float) -> Dictionary[Control, float]:
	var wishes: Dictionary[Control, float] = {}
	var all := 0.0
	for part in parts:
		if part is CappedScroll:
			wishes[part] = (
				(part as CappedScroll).get_wanted_height() - part.get_combined_minimum_size().y
			)
			all += wishes[part]
	if all <= room:
		return wishes
	var rest := room
	for part: Control in wishes:
		var others := all - wishes[part]
		wishes[part] = minf(
			wishes[part],
			maxf(rest - others, room * FIRST_SHARE if part == wishes.keys()[0] else rest)
		)
		rest -= wishes[part]
	return wishes


func _get_parts() -> Array[Control]:
	var parts: Array[Control] = []
	for child in get_children():
		var is_empty := child is CappedScroll and (child as CappedScroll).get_wanted_height() == 0.0
		if child is Control and (child as Control).visible and not is_empty:
			parts.append(child)
	return parts


func _separation() -> float:
	return SEPARATION * PlaygroundStyle.scale()
