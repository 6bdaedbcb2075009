extends Node3D
## Objects in one space: endless ones reach the horizon, surfaces are transparent, labels are beside
## their objects.

const DrawnScene := preload("res://tests/pictures/drawn_scene.gd")

const BLUE := Color(0.36, 0.72, 1.0)
const ORANGE := Color(1.0, 0.68, 0.3)
const GREEN := Color(0.45, 0.85, 0.5)
const RED := Color(1.0, 0.48, 0.55)
const GRAY := Color(0.72, 0.76, 0.82)


static func make() -> DrawnScene:
	var scene := DrawnScene.new()
	scene._build()
	return scene


func _build() -> void:
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.11, 0.125, 0.15)
	add_child(world)
	var camera := Camera3D.new()
	camera.fov = 55.0
	camera.look_at_from_position(Vector3(2.5, 2.6, 7.5), Vector3(0.4, 1.1, 0.0))
	add_child(camera)
	var a := Multivector.point(Vector3(-3.2, 0.0, 2.0))
	var b := Multivector.point(Vector3(-1.4, 2.4, 1.2))
	var c := Multivector.point(Vector3(-3.6, 2.6, -0.6))
	var sphere := Multivector.sphere(Vector3(1.2, 1.1, 0.0), 1.4)
	var other := Multivector.sphere(Vector3(2.8, 1.6, -0.8), 1.1)
	var far := Multivector.sphere(Vector3(4.7, 0.8, -4.0), 0.8)
	var farther := Multivector.sphere(Vector3(7.0, 1.3, -5.0), 1.1)
	var ground := Multivector.plane(Vector3.UP, 0.0)
	var line := Multivector.line(Vector3(-3.2, 0.0, 2.0), Vector3(1.8, 2.4, -0.8))
	_draw("ground", ground, GRAY)
	_draw("S", sphere, BLUE)
	_draw("T", other, GREEN)
	_draw("S meets T", sphere.meet(other), ORANGE, 3.0)
	_draw("S meets the ground", sphere.meet(ground), BLUE)
	_draw("a", a, RED)
	_draw("b", b, RED)
	_draw("c", c, RED)
	_draw(
		"a ^ b ^ c",
		Multivector.circle_through(
			Vector3(-3.2, 0.0, 2.0), Vector3(-1.4, 2.4, 1.2), Vector3(-3.6, 2.6, -0.6)
		),
		RED
	)
	_draw("", line, ORANGE)
	_draw("", far, GREEN)
	_draw("", farther, GREEN)
	_draw("imaginary", far.meet(farther), GREEN)
	_draw(
		"huge circle",
		Multivector.circle(Vector3(2e4 - 7.0, 0.0, -6.0), Vector3(0.0, 0.0, 1.0), 2e4),
		BLUE
	)


func _draw(title: String, value: Multivector, color: Color, width := 2.0) -> void:
	var node := GANode3D.new()
	node.multivector = value
	node.color = color
	node.line_width = width
	node.label = title
	node.show_label = not title.is_empty()
	add_child(node)
