extends "res://tests/framework/test_case.gd"
## GANode3D: the source of its value, when it draws, its label, picking.

var _camera: Camera3D
var _node: GANode3D


func test_defaults() -> void:
	_build()
	expect_null(_node.multivector, "multivector")
	expect_null(_node.scene, "scene")
	expect_equal(_node.entry, &"", "entry")
	expect_equal(_node.ipns, false, "ipns")
	expect_equal(_node.show_label, false, "show_label")
	expect_equal(_node.label, "", "label")
	expect_equal(_node.line_width, 2.0, "line_width")
	expect_equal(_node.describe(), "no value", "description")


func test_a_multivector_of_its_own() -> void:
	_build()
	_node.multivector = Multivector.sphere(Vector3(1, 2, 3), 2.0)
	expect_true(
		_node.describe().begins_with("sphere, radius 2, center (1, 2, 3)"), _node.describe()
	)
	_node.ipns = true
	_node.multivector = _node.multivector.dual()
	expect_true(_node.describe().begins_with("dual sphere"), _node.describe())


func test_it_follows_changes_in_place() -> void:
	_build()
	var value := Multivector.point(Vector3(0, 0, 0))
	_node.multivector = value
	await wait_frames(1)
	expect_near(_distance_to(Vector3.ZERO), 0.0, 0.5, "distance of the point")
	value.coefficients = Multivector.point(Vector3(1, 0, 0)).coefficients
	await wait_frames(1)
	expect_near(_distance_to(Vector3(1, 0, 0)), 0.0, 0.5, "distance of the moved point")
	expect_true(_distance_to(Vector3.ZERO) > 20.0, "nothing is drawn at the old position")


func test_an_entry_of_a_scene() -> void:
	_build()
	var scene := GAScene.new()
	scene.add_entry("a", "point(0, 0, 0)")
	scene.add_entry("s", "sphere(a, 1)")
	_node.scene = scene
	_node.entry = &"s"
	expect_true(_node.describe().begins_with("sphere, radius 1"), _node.describe())
	scene.set_expression("a", "point(1, 0, 0)")
	expect_true(_node.describe().contains("center (1, 0, 0)"), _node.describe())
	# A scene takes precedence over a multivector. A missing entry draws nothing and is no error.
	_node.multivector = Multivector.point(Vector3.ZERO)
	_node.entry = &"missing"
	expect_equal(_node.describe(), "no value", "description")
	_node.scene = null
	expect_true(_node.describe().begins_with("point"), _node.describe())


func test_attributes_of_an_entry() -> void:
	_build()
	var scene := GAScene.new()
	scene.add_entry("a", "point(0, 0, 0)")
	_node.scene = scene
	_node.entry = &"a"
	expect_near(_distance_to(Vector3.ZERO), 0.0, 0.5, "distance of the point")
	scene.set_entry_attribute("a", "visible", false)
	expect_equal(_distance_to(Vector3.ZERO), INF, "a hidden entry is not drawn")
	scene.set_entry_attribute("a", "visible", true)
	scene.set_expression("a", "!point(0, 0, 0)")
	scene.set_entry_attribute("a", "ipns", true)
	expect_true(_node.describe().begins_with("dual point"), _node.describe())
	scene.set_entry_attribute("a", "color", "#ff8000")
	await wait_frames(1)
	expect_equal(_node.color, Color(0.35, 0.7, 1.0), "the node's color does not change")


func test_a_drawn_entry_that_changes_name_goes_and_comes() -> void:
	_build()
	var scene := GAScene.new()
	scene.add_entry("a", "point(0, 0, 0)")
	scene.add_entry("b", "point(2, 0, 0)")
	_node.scene = scene
	_node.entry = &"a"
	await wait_frames(1)
	scene.set_expression("b", "point(3, 0, 0)")
	await wait_frames(1)
	expect_near(_distance_to(Vector3.ZERO), 0.0, 0.5, "after a change of another entry")
	scene.set_expression("a", "point(1, 0, 0)")
	await wait_frames(1)
	expect_near(_distance_to(Vector3(1, 0, 0)), 0.0, 0.5, "after a change")
	scene.set_expression("a", "point(1, 0,")
	await wait_frames(1)
	expect_equal(_distance_to(Vector3(1, 0, 0)), INF, "an entry with an error")
	scene.set_expression("a", "point(1, 0, 0)")
	scene.rename_entry("a", "c")
	await wait_frames(1)
	expect_equal(_distance_to(Vector3(1, 0, 0)), INF, "after the entry was renamed")
	scene.rename_entry("b", "a")
	await wait_frames(1)
	expect_near(_distance_to(Vector3(3, 0, 0)), 0.0, 0.5, "another entry of that name")
	scene.remove_entry("a")
	await wait_frames(1)
	expect_equal(_distance_to(Vector3(3, 0, 0)), INF, "after the entry was removed")


func test_every_kind_and_every_change_between_kinds() -> void:
	_build()
	_node.show_label = true
	var expressions: Array[String] = [
		"point(1, 0, 0)",
		"flat_point(1, 0, 0)",
		"pair(point(0, 0, 0), point(1, 0, 0))",
		"line(point(0, 0, 0), e1)",
		"circle(point(0, 0, 0), e3, 1)",
		"plane(e2, 1)",
		"sphere(point(0, 0, 0), 1)",
		"imaginary_circle(point(0, 0, 0), e3, 1)",
		"tangent_along(point(0, 0, 0), e1)",
		"tangent_across(point(0, 0, 0), e1)",
		"direction(e1)",
		"direction_across(e1)",
		"translator(e1)",
		"rotor(e2, 1)",
		"dilator(2)",
		"translator(e1) * rotor(e2, 1)",
		"3",
		"einf",
		"e1 + e23",
		"0"
	]
	for first in expressions:
		_node.multivector = Multivector.evaluate(first)
		for ipns: bool in [false, true]:
			_node.ipns = ipns
			_node.update_drawing()
	for second: String in expressions:
		_node.multivector = Multivector.evaluate(second)
		await wait_frames(1)
	_node.multivector = null
	await wait_frames(1)
	expect_equal(_distance_to(Vector3.ZERO), INF, "nothing is drawn")


func test_extreme_values_draw_without_error() -> void:
	_build()
	for radius: float in [1e-6, 1e-3, 1e5, 1e9]:
		for place: float in [0.0, 1e4, 1e7]:
			_node.multivector = Multivector.circle(Vector3(place, 0, 0), Vector3(1, 2, 3), radius)
			_node.update_drawing()
			_node.multivector = Multivector.sphere(Vector3(place, 0, 0), radius)
			_node.update_drawing()
	var far_apart := Multivector.new()
	var coefficients := far_apart.coefficients
	coefficients[4] = 1e300
	coefficients[5] = 1e-300
	coefficients[1] = 1e200
	far_apart.coefficients = coefficients
	_node.multivector = far_apart
	_node.update_drawing()
	expect_true(true, "no error")


func test_leaving_and_entering_the_tree() -> void:
	_build()
	_node.multivector = Multivector.sphere(Vector3.ZERO, 1.0)
	_node.show_label = true
	await wait_frames(1)
	var parent := _node.get_parent()
	for i in 3:
		parent.remove_child(_node)
		_node.multivector = Multivector.circle(Vector3.ZERO, Vector3.UP, 1.0 + i)
		parent.add_child(_node)
		await wait_frames(1)
	_node.hide()
	_node.show()
	_node.position = Vector3(1, 0, 0)
	expect_near(_distance_to(Vector3(4, 0, 0)), 0.0, 0.5, "the circle of radius 3 moved by 1")


func test_the_label() -> void:
	_build()
	_node.name = "Ball"
	_node.multivector = Multivector.sphere(Vector3(1, 0, 0), 2.0)
	_node.show_label = true
	await wait_frames(1)
	var label: Label3D = _node.get_child(0, true)
	expect_equal(label.text, "Ball", "text")
	expect_equal(label.visible, true, "visible")
	expect_vector_near(label.position, Vector3(1, 2, 0), 1e-5, "on top of the sphere")
	_node.label = "S"
	expect_equal(label.text, "S", "text")
	_node.show_label = false
	expect_equal(label.visible, false, "visible")
	expect_equal(_node.get_child_count(), 0, "children that a scene would save")


func test_distances_on_the_screen() -> void:
	_build()
	_node.multivector = Multivector.circle(Vector3.ZERO, Vector3.BACK, 1.0)
	expect_near(_distance_to(Vector3(0, 1, 0)), 0.0, 0.5, "on the circle")
	var edge := _camera.unproject_position(Vector3(1, 0, 0))
	expect_near(
		_node.get_screen_distance(_camera, edge + Vector2(7, 0)), 7.0, 0.5, "beside the circle"
	)
	_node.scale = Vector3(2, 2, 2)
	expect_near(_distance_to(Vector3(0, 2, 0)), 0.0, 0.5, "on the circle, twice as large")
	_node.scale = Vector3.ONE
	_camera.set_orthogonal(5.0, 0.1, 100.0)
	expect_near(_distance_to(Vector3(0, 1, 0)), 0.0, 0.5, "in an orthogonal view")
	expect_near(
		_node.get_screen_distance(
			_camera, _camera.unproject_position(Vector3(1, 0, 0)) + Vector2(7, 0)
		),
		7.0,
		0.5,
		"beside it in an orthogonal view"
	)
	_node.multivector = Multivector.point(Vector3(0, 0, 50))
	expect_equal(_distance_to(Vector3.ZERO), INF, "behind the camera")


func test_errors_are_reported() -> void:
	_build()
	expect_error("GANode3D.line_width: the width must be above 0 and at most 100 pixels, not 0.0.")
	_node.line_width = 0.0
	expect_equal(_node.line_width, 2.0, "line_width")
	var freed := Camera3D.new()
	freed.free()
	for camera: Variant in [null, freed]:
		expect_error(
			(
				"GANode3D.get_screen_distance: the camera is null or outside the scene tree; "
				+ "pass the camera that renders this node."
			)
		)
		expect_equal(
			_node.call(&"get_screen_distance", camera, Vector2.ZERO), INF, "without a camera"
		)


func _build() -> void:
	var world := Node3D.new()
	add_node(world)
	_camera = Camera3D.new()
	_camera.position = Vector3(0, 0, 10)
	world.add_child(_camera)
	_node = GANode3D.new()
	world.add_child(_node)


## Distance on the screen from a projected position to what the node draws.
func _distance_to(place: Vector3) -> float:
	return _node.get_screen_distance(_camera, _camera.unproject_position(place))
