extends "res://tests/framework/test_case.gd"
## GAScene: handles, and expressions that follow the mouse.

const EYE := Vector3(0, 0, 10)

var _scene := GAScene.new()


func test_the_handles_of_objects() -> void:
	var cases: Dictionary[String, Dictionary] = {
		"point(1, 2, 3)": {"position": Vector3(1, 2, 3)},
		"sphere(e2, 2)": {"center": Vector3.UP, "radius": Vector3(2, 1, 0)},
		"circle(0, e2, 2)":
		{"center": Vector3.ZERO, "radius": Vector3(2, 0, 0), "normal": Vector3.UP},
		"plane(e3, 2)": {"distance": Vector3(0, 0, 2), "normal": Vector3(0, 0, 3)},
		"motor(e1, rotor(e3, 0))":
		{"translation": Vector3.RIGHT, "axis": Vector3(1, 0, 1), "angle": Vector3(1.65, 0, 0)},
		"2.5": {},
		"point(1, 2": {},
	}
	_scene.add_entry("x", "1")
	for expression in cases:
		_scene.set_expression("x", expression)
		var positions := {}
		for handle in _scene.get_handles("x"):
			positions[handle.key] = handle.position
		expect_equal(positions, cases[expression], "handles of %s" % expression)


func test_the_radius_is_at_the_right_of_the_view() -> void:
	_scene.add_entry("s", "sphere(0, 2)")
	var handle: Dictionary = _scene.get_handles("s", Vector3(0, 0, -3))[1]
	expect_equal(handle.position, Vector3(0, 0, -2), "position")
	expect_equal(handle.stem, Vector3.ZERO, "stem")
	expect_equal(handle.motion, "line", "motion")
	expect_equal(handle.axis, Vector3.FORWARD, "axis")
	expect_equal([handle.is_arm, handle.moves_body], [false, false], "flags")


func test_dragging() -> void:
	_scene.add_entry("a", "point(1, 0, 0)")
	_scene.add_entry("s", "sphere(a, 1)")
	var changed: Array[PackedStringArray] = []
	_scene.entries_changed.connect(func(names: PackedStringArray) -> void: changed.append(names))
	var handle: Dictionary = _scene.get_handles("a")[0]
	expect_equal(_drag("a", handle, Vector3(2.34, -1.27, 0), 0.1), OK, "dragging")
	expect_equal(_scene.get_expression("a"), "point(2.3, -1.3, 0)", "expression")
	expect_equal(
		changed, [PackedStringArray(["a", "s"])] as Array[PackedStringArray], "changed entries"
	)
	handle = _scene.get_handles("s")[0]
	expect_equal(_drag("s", handle, Vector3(4, -1.3, 0), 0.1), OK, "dragging the radius")
	expect_equal(_scene.get_expression("s"), "sphere(a, 1.7)", "expression")


func test_an_arm_may_be_drawn_longer() -> void:
	_scene.add_entry("c", "circle(0, e2, 1)")
	var handle: Dictionary = _scene.get_handles("c")[2]
	handle.position = (handle.stem as Vector3).lerp(handle.position as Vector3, 3.0)
	expect_equal(
		_scene.drag_handle(
			"c", handle, Vector3(4, 0, 10), Vector3.FORWARD, Vector3.FORWARD, 0.0, deg_to_rad(15)
		),
		OK,
		"dragging the normal"
	)
	expect_equal(_scene.get_expression("c"), "circle(0, e1, 1)", "expression")


func test_the_grabbed_point_stays_under_the_mouse() -> void:
	_scene.add_entry("s", "sphere(0, 1)")
	var handle: Dictionary = _scene.get_handles("s")[0]
	handle.grab = Vector3(0.5, 0.5, 0)
	expect_equal(_drag("s", handle, Vector3(2.5, 3.5, 0), 0.5), OK, "dragging")
	expect_equal(_scene.get_expression("s"), "sphere(2 e1 + 3 e2, 1)", "expression")


## No error is printed, as the mouse may be anywhere.
func test_rays_that_no_handle_can_follow() -> void:
	_scene.add_entry("s", "sphere(e1, 2)")
	_scene.add_entry("p", "point_pair(point(0, 0, 0), point(1, 0, 0))")
	for handle in _scene.get_handles("s"):
		for ray: Array in [
			[EYE, Vector3.ZERO],
			[EYE, Vector3.BACK],
			[EYE, Vector3(NAN, 0, -1)],
			[Vector3(INF, 0, 0), Vector3.FORWARD]
		]:
			expect_equal(
				_scene.drag_handle(
					"s", handle, ray[0] as Vector3, ray[1] as Vector3, Vector3.FORWARD
				),
				ERR_SKIP,
				"%s by %s" % [handle.key, ray]
			)
	expect_equal(
		_drag("s", _scene.get_handles("s")[1], Vector3(-5, 0, 0), 0.0),
		ERR_SKIP,
		"a radius below zero"
	)
	expect_equal(
		_drag("p", _scene.get_handles("p")[0], Vector3(1, 0, 0), 1.0),
		ERR_SKIP,
		"two points at one position"
	)
	expect_equal(_scene.get_expression("s"), "sphere(e1, 2)", "expression")
	expect_equal(
		_scene.get_expression("p"), "point_pair(point(0, 0, 0), point(1, 0, 0))", "expression"
	)


func test_invalid_arguments() -> void:
	_scene.add_entry("s", "sphere(e1, 2)")
	var handle: Dictionary = _scene.get_handles("s")[1]
	expect_error('GAScene.get_handles: there is no entry "x"; get_names() lists the entries.')
	expect_equal(_scene.get_handles("x").size(), 0, "handles of an unknown entry")
	expect_error('GAScene.drag_handle: there is no entry "x"; get_names() lists the entries.')
	expect_equal(_drag("x", handle, Vector3.ZERO, 0.0), ERR_INVALID_PARAMETER, "dragging nothing")
	for wrong: Dictionary in [
		{},
		{"key": "radius"},
		handle.merged({"motion": "round"}, true),
		handle.merged({"position": 3}, true),
		handle.merged({"axis": Vector3(NAN, 0, 0)}, true)
	]:
		expect_error(
			"GAScene.drag_handle: the handle must be a dictionary from get_handles(), with all of its keys."
		)
		expect_equal(_drag("s", wrong, Vector3.ZERO, 0.0), ERR_INVALID_PARAMETER, "a wrong handle")
	expect_error(
		(
			"GAScene.drag_handle: step and angle_step must be finite and at least 0 (0 for no steps), "
			+ "not -1.000000 and 0.000000."
		)
	)
	expect_equal(_drag("s", handle, Vector3.ZERO, -1.0), ERR_INVALID_PARAMETER, "a wrong step")
	expect_equal(_scene.get_expression("s"), "sphere(e1, 2)", "expression")


func _drag(entry: String, handle: Dictionary, to: Vector3, step: float) -> Error:
	return _scene.drag_handle(entry, handle, EYE, to - EYE, Vector3.FORWARD, step)
