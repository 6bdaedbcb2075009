extends "res://tests/framework/test_case.gd"
## GAScene: parameters of free objects.

var _scene := GAScene.new()


func test_the_parameters_of_objects() -> void:
	var turn := Quaternion(Vector3.BACK, PI / 2.0)
	var cases: Dictionary[String, Dictionary] = {
		"2.5": {"value": 2.5},
		"point(1, -2, 3)": {"position": Vector3(1, -2, 3)},
		"point_pair(e1, e2)": {"a": Vector3.RIGHT, "b": Vector3.UP},
		"line(e1, 2 e2)": {"point": Vector3.RIGHT, "direction": Vector3(0, 2, 0)},
		"circle(e1, e2, 2)": {"center": Vector3.RIGHT, "normal": Vector3.UP, "radius": 2.0},
		"plane(e3, -1)": {"normal": Vector3.BACK, "distance": -1.0},
		"!sphere(0, 2)": {"center": Vector3.ZERO, "radius": 2.0},
		"translator(1, 2, 3)": {"offset": Vector3(1, 2, 3)},
		"motor_from(e1, rotor(0, 0, %s, %s), 2)" % [turn.z, turn.w]:
		{"translation": Vector3.RIGHT, "rotation": turn, "scale": 2.0},
		"sphere(a, 2)": {"radius": 2.0},
		"a + 1": {},
		"point(1, 2": {},
	}
	_scene.add_entry("a", "eo")
	_scene.add_entry("x", "1")
	for expression in cases:
		_scene.set_expression("x", expression)
		var parameters := _scene.get_parameters("x")
		parameters.erase("coefficients")
		if parameters.has("rotation"):
			var rotation: Quaternion = parameters.rotation
			expect_true(rotation.is_equal_approx(turn), "rotation %s" % rotation)
			parameters.rotation = turn
		expect_equal(parameters, cases[expression], "parameters of %s" % expression)


func test_dragging_rewrites_the_literals() -> void:
	_scene.add_entry("p", "point( 1, 2,3 )")
	_scene.add_entry("s", "sphere(p, 1.5)")
	expect_equal(_scene.set_parameter("p", "position", Vector3(1.1, 2, -0.3)), OK, "dragging")
	expect_equal(_scene.get_expression("p"), "point( 1.1, 2,-0.3 )", "expression")
	expect_vector_near(
		_scene.get_value("s").classify().center as Vector3, Vector3(1.1, 2, -0.3), 1e-6
	)
	expect_equal(_scene.set_parameter("s", "radius", 2), OK, "setting an integer")
	expect_equal(_scene.get_expression("s"), "sphere(p, 2)", "expression")


func test_invalid_parameters_are_refused() -> void:
	_scene.add_entry("s", "sphere(e1, 1.5)")
	expect_error("GAScene.set_parameter: sphere: the radius must be a finite number above zero.")
	expect_equal(
		_scene.set_parameter("s", "radius", -1.0), ERR_INVALID_PARAMETER, "a negative radius"
	)
	expect_error(
		"GAScene.set_parameter: the expression has no parameter 'size'; it has center, radius."
	)
	expect_equal(_scene.set_parameter("s", "size", 1.0), ERR_INVALID_PARAMETER, "an unknown key")
	expect_error("GAScene.set_parameter: the parameter 'center' must be a vector, not a number.")
	expect_equal(_scene.set_parameter("s", "center", 1.0), ERR_INVALID_PARAMETER, "a wrong type")
	expect_error(
		(
			'GAScene.set_parameter: the parameter "center" must be a number, a Vector3, a Quaternion, '
			+ "a Multivector or a PackedFloat64Array of 32 coefficients, not String."
		)
	)
	expect_equal(_scene.set_parameter("s", "center", "e1"), ERR_INVALID_PARAMETER, "a string")
	expect_error("GAScene.set_parameter: the parameter 'center' must be finite.")
	expect_equal(
		_scene.set_parameter("s", "center", Vector3(NAN, 0, 0)), ERR_INVALID_PARAMETER, "no number"
	)
	expect_equal(_scene.get_expression("s"), "sphere(e1, 1.5)", "expression")


func test_coefficients_are_edited_one_by_one() -> void:
	_scene.add_entry("x", Multivector.point(Vector3(1, 2, 3)).to_json())
	var coefficients: PackedFloat64Array = _scene.get_parameters("x").coefficients
	coefficients[3] = 0.1
	expect_equal(
		_scene.set_parameter("x", "coefficients", coefficients), OK, "setting coefficients"
	)
	expect_equal(_scene.get_value("x").coefficients, coefficients, "coefficients")
	_scene.add_entry("y", "1 + 2 e12")
	expect_equal(
		_scene.set_parameter("y", "coefficients", Multivector.basis("e3").scaled(2.5)),
		OK,
		"setting a multivector"
	)
	expect_equal(_scene.get_expression("y"), "2.5 e3", "expression")
