extends Control
## The background of the menu: two orthogonal pencils of circles, those through two points and those
## orthogonal to them. In conformal geometric algebra a pencil consists of the linear combinations
## of two circles.

const LINE_WIDTH := 1.5
const CIRCLE_POINTS := 192
const THROUGH_COLOR := Color(0.24, 0.84, 0.77)
const ORTHOGONAL_COLOR := Color(1.0, 0.65, 0.32)
## Offsets of the centers of the circles through both points. The unit is half the distance
## between the points.
const THROUGH_OFFSETS: Array[float] = [0.0, 0.55, 1.2, 2.1]
## Centers of the orthogonal circles in the same unit, outside the segment between the points.
const ORTHOGONAL_CENTERS: Array[float] = [1.06, 1.25, 1.65, 2.6]


func _ready() -> void:
	resized.connect(queue_redraw)


func _draw() -> void:
	var middle := Vector2(size.x * 0.79, size.y * 0.5)
	var half := size.y * 0.2
	for offset in THROUGH_OFFSETS:
		var fade := 0.5 / (1.0 + 0.45 * offset)
		var radius := half * sqrt(1.0 + offset * offset)
		_draw_circle(middle + Vector2(half * offset, 0.0), radius, Color(THROUGH_COLOR, fade))
		if offset > 0.0:
			_draw_circle(middle - Vector2(half * offset, 0.0), radius, Color(THROUGH_COLOR, fade))
	for center in ORTHOGONAL_CENTERS:
		var fade := 0.62 / center
		var radius := half * sqrt(center * center - 1.0)
		_draw_circle(middle + Vector2(0.0, half * center), radius, Color(ORTHOGONAL_COLOR, fade))
		_draw_circle(middle - Vector2(0.0, half * center), radius, Color(ORTHOGONAL_COLOR, fade))
	for side: float in [-1.0, 1.0]:
		draw_circle(middle + Vector2(0.0, half * side), 4.0, Color.WHITE, true, -1.0, true)


func _draw_circle(center: Vector2, radius: float, color: Color) -> void:
	draw_arc(center, radius, 0.0, TAU, CIRCLE_POINTS, color, LINE_WIDTH, true)
