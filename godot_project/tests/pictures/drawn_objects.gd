extends Control
## Every kind of object that GANode3D draws, each in its own view: direct, dual, imaginary, motors.

const DrawnObjects := preload("res://tests/pictures/drawn_objects.gd")

const COLUMNS := 6
const ROWS := 4
const BACKGROUNDS: Array[Color] = [Color(0.11, 0.125, 0.15), Color(0.95, 0.953, 0.96)]
const LETTERS: Array[Color] = [Color(0.72, 0.75, 0.8), Color(0.3, 0.33, 0.38)]
const COLORS: Array[Color] = [
	Color(0.36, 0.72, 1.0), Color(1.0, 0.68, 0.3), Color(0.45, 0.85, 0.5), Color(1.0, 0.48, 0.55)
]
const COLORS_ON_LIGHT: Array[Color] = [
	Color(0.05, 0.42, 0.8), Color(0.75, 0.38, 0.02), Color(0.08, 0.5, 0.2), Color(0.8, 0.14, 0.26)
]
## Expressions by title. Those with the prefix "dual:" are interpreted as IPNS.
const OBJECTS: Dictionary[String, String] = {
	"point": "point(0, 0, 0)",
	"dual point": "dual:!point(0, 0, 0)",
	"flat point": "flat_point(0, 0, 0)",
	"point pair": "pair(point(-0.8, -0.4, 0), point(0.8, 0.4, 0))",
	"dual point pair": "dual:!pair(point(-0.8, -0.4, 0), point(0.8, 0.4, 0))",
	"imaginary point pair": "imaginary_point_pair(point(0, 0, 0), 2 e1 + e2, 0.9)",
	"line": "line(point(0, 0.1, 0), 3 e1 + e2 - 2 e3)",
	"dual line": "dual:!line(point(0, 0.1, 0), 3 e1 + e2 - 2 e3)",
	"circle": "circle(point(0, 0, 0), e1 + 4 e2 + 2 e3, 1)",
	"dual circle": "dual:!circle(point(0, 0, 0), e1 + 4 e2 + 2 e3, 1)",
	"imaginary circle": "imaginary_circle(point(0, 0, 0), e1 + 4 e2 + 2 e3, 1)",
	"tangent along a line": "tangent_along(point(0, 0, 0), 2 e1 + e2 + e3)",
	"plane": "plane(e2, -0.7)",
	"dual plane, its back": "dual:!plane(-e2, 0.7)",
	"sphere": "sphere(point(0, 0, 0), 0.95)",
	"dual sphere, turned inward": "dual:!(-sphere(point(0, 0, 0), 0.95))",
	"imaginary sphere": "imaginary_sphere(point(0, 0, 0), 0.95)",
	"tangent across a plane": "tangent_across(point(0, 0, 0), e1 + 2 e2 + 2 e3)",
	"direction": "direction(2 e1 + e2 + e3)",
	"direction across": "direction_across(e1 + 3 e2 + 2 e3)",
	"translator": "translator(1.1 e1 + 0.5 e2)",
	"rotor": "rotor(e2, 2)",
	"motor": "translator(0.9 e1 + 0.6 e2) * rotor(e1 + 2 e2, 2.4)",
	"motor that scales": "translator(0.9 e1 + 0.3 e2) * rotor(e2, 1.5) * dilator(1.8)",
}


static func make(light: bool) -> DrawnObjects:
	var picture := DrawnObjects.new()
	picture._build(int(light), COLORS_ON_LIGHT if light else COLORS)
	return picture


func _build(theme_index: int, colors: Array[Color]) -> void:
	set_anchors_preset(PRESET_FULL_RECT)
	var back := ColorRect.new()
	back.color = BACKGROUNDS[theme_index].lerp(LETTERS[theme_index], 0.25)
	back.set_anchors_preset(PRESET_FULL_RECT)
	add_child(back)
	var grid := GridContainer.new()
	grid.columns = COLUMNS
	grid.set_anchors_preset(PRESET_FULL_RECT)
	grid.add_theme_constant_override(&"h_separation", 1)
	grid.add_theme_constant_override(&"v_separation", 1)
	add_child(grid)
	for title: String in OBJECTS:
		grid.add_child(
			_cell(title, OBJECTS[title], theme_index, colors[grid.get_child_count() / COLUMNS])
		)


func _cell(title: String, expression: String, theme_index: int, color: Color) -> Control:
	var container := SubViewportContainer.new()
	container.stretch = true
	container.size_flags_horizontal = SIZE_EXPAND_FILL
	container.size_flags_vertical = SIZE_EXPAND_FILL
	var view := SubViewport.new()
	view.own_world_3d = true
	container.add_child(view)
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = BACKGROUNDS[theme_index]
	view.add_child(world)
	var camera := Camera3D.new()
	camera.fov = 36.0
	camera.look_at_from_position(Vector3(1.2, 1.7, 4.6), Vector3(0.0, -0.1, 0.0))
	view.add_child(camera)
	var node := GANode3D.new()
	node.multivector = Multivector.evaluate(expression.trim_prefix("dual:"))
	node.ipns = expression.begins_with("dual:")
	node.color = color
	view.add_child(node)
	var label := Label.new()
	label.text = title
	label.add_theme_font_size_override(&"font_size", 13)
	label.add_theme_color_override(&"font_color", LETTERS[theme_index])
	label.set_anchors_preset(PRESET_BOTTOM_WIDE)
	label.position.y -= 6.0
	label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	label.vertical_alignment = VERTICAL_ALIGNMENT_BOTTOM
	label.grow_vertical = GROW_DIRECTION_BEGIN
	label.offset_bottom = -6.0
	view.add_child(label)
	return container
