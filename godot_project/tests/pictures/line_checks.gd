extends RefCounted
## Checks that a line has a constant width up to the horizon, also if it starts behind the camera.

const PictureExport := preload("res://addons/ga_godot/playground/picture/picture_export.gd")

const SIZE := Vector2i(640, 360)
const WIDTH := 10.0
const LIT := 0.3
## First checked row, below the horizon.
const FIRST_ROW := 30
## Tolerance in pixels.
const ALLOWED := 1.5


## Returns a description of the error, or an empty string. A coroutine. The host is any node in the
## tree.
static func find_problem(host: Node) -> String:
	var scene := GAScene.new()
	scene.add_entry("l", "line(point(1, 0, 0), e3)")
	scene.set_entry_attribute("l", "label", false)
	scene.set_entry_attribute("l", "line_width", WIDTH)
	var export := PictureExport.new()
	export.size = SIZE
	export.background = Color.BLACK
	export.view.from = Vector3(3.2, 4.0, 6.8)
	export.view.to = Vector3(0.0, 1.45, 0.0)
	var picture := await export.draw(host, scene)
	# Rows cut the line at an angle. Arrowheads only make it wider.
	var direction := _direction_on_screen(export)
	var expected := WIDTH / absf(direction.y)
	for y in range(FIRST_ROW, SIZE.y):
		var lit := 0
		for x in SIZE.x:
			lit += int(picture.get_pixel(x, y).get_luminance() > LIT)
		if lit < expected - ALLOWED:
			return "the line is %d pixels wide in row %d, not %.1f" % [lit, y, expected]
	return ""


static func _direction_on_screen(export: PictureExport) -> Vector2:
	var eye := export.view.get_transform().affine_inverse()
	var near := eye * Vector3(1.0, 0.0, 0.0)
	var far := eye * Vector3(1.0, 0.0, -5.0)
	return (Vector2(far.x, far.y) / -far.z - Vector2(near.x, near.y) / -near.z).normalized()
