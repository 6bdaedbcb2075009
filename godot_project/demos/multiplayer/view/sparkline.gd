extends Control
## A small graph of the recent values of a statistic.

const CAPACITY := 48

var color := Color.WHITE

var _values := PackedFloat32Array()


## Clears the values and sets the color.
func begin(p_color: Color) -> void:
	color = p_color
	_values.clear()
	queue_redraw()


func push(value: float) -> void:
	_values.append(value)
	if _values.size() > CAPACITY:
		_values.remove_at(0)
	queue_redraw()


func _draw() -> void:
	if _values.size() < 2:
		return
	var max_value := 1.0
	for value: float in _values:
		max_value = maxf(max_value, value)
	var curve := PackedVector2Array()
	var start := CAPACITY - _values.size()
	for i: int in _values.size():
		curve.append(
			Vector2(
				size.x * (start + i) / (CAPACITY - 1),
				size.y - 1.0 - (size.y - 3.0) * _values[i] / (max_value * 1.1)
			)
		)
	var area := curve.duplicate()
	area.append(Vector2(curve[-1].x, size.y))
	area.append(Vector2(curve[0].x, size.y))
	draw_colored_polygon(area, Color(color, 0.16))
	draw_polyline(curve, color, 1.5, true)
