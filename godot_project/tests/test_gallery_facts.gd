extends "res://tests/framework/test_case.gd"
## What the texts of the examples claim, checked with numbers.

const Gallery := preload("res://addons/ga_godot/playground/document/gallery.gd")

const EXACT := 1e-9

var _scene: GAScene


func test_a_circle_through_its_points() -> void:
	_open("circle_through_points")
	for i in 2:
		for point: String in ["a", "b", "c"]:
			_expect_zero("normalized(circle) ^ %s" % point)
			_expect_zero("normalized(disc_plane) ^ %s" % point)
		_expect_zero("axis ^ center / norm(axis)")
		_expect_position("center", _center_of("circle"))
		_drag("b", Vector3(2.5, -1.0, 0.25))
	_drag("a", Vector3(0, 0, 0))
	_drag("b", Vector3(1, 0, 0))
	_drag("c", Vector3(3, 0, 0))
	_expect_kind("circle", "line")


func test_a_sphere_through_its_points() -> void:
	_open("sphere_through_points")
	for point: String in ["a", "b", "c", "d"]:
		_expect_zero("normalized(sphere) ^ %s" % point)
	for circle: String in ["abc", "abd", "acd", "bcd"]:
		_expect_zero("reject_from(%s, sphere)" % circle)
	_drag("a", Vector3(1, 0, 0))
	_drag("b", Vector3(0, 0, 1))
	_drag("c", Vector3(-1, 0, 0))
	_drag("d", Vector3(0.5, 0, 0.25))
	_expect_kind("sphere", "plane")


func test_joins_hold_their_points_and_meets_lie_in_both() -> void:
	_open("join_and_meet")
	for point: String in ["a", "b"]:
		_expect_zero("line ^ %s" % point)
	_expect_kind("spot", "flat_point")
	for through: String in ["line", "wall"]:
		_expect_zero("reject_from(spot, %s)" % through)
	_expect_kind("edge", "line")
	for through: String in ["ground", "wall"]:
		_expect_zero("reject_from(edge, %s)" % through)
	_expect_kind("through", "point_pair")
	expect_equal(_is_imaginary("through"), false, "imaginary")
	_scene.set_parameter("ball", "center", Vector3(0.55, 5.0, 0.1))
	expect_equal(_is_imaginary("through"), true, "imaginary if the line misses the sphere")


func test_a_circle_from_real_through_tangent_to_imaginary() -> void:
	_open("sphere_and_plane")
	expect_equal(
		[_kind("circle"), _kind("contact"), _kind("imaginary")],
		["circle", "tangent", "circle"] as Array,
		"kinds"
	)
	expect_equal(_is_imaginary("circle"), false, "imaginary, sphere that is cut")
	expect_equal(_is_imaginary("imaginary"), true, "imaginary, sphere that is missed")
	# The middle sphere has its center at height 1, and radius 1.
	var kinds := PackedStringArray()
	for height: float in [1.0, 1.6, 1.999, 2.0, 2.001, 2.5]:
		_scene.set_parameter("height", "value", height)
		kinds.append("%s%s" % ["imaginary " if _is_imaginary("contact") else "", _kind("contact")])
		var squared := 1.0 - (height - 1.0) ** 2
		var description: Dictionary = _scene.get_value("contact").classify()
		if description.has("radius"):
			expect_near(
				description["radius"] as float, sqrt(absf(squared)), 1e-6, "radius at %s" % height
			)
	expect_equal(
		kinds,
		PackedStringArray(
			["circle", "circle", "circle", "tangent", "imaginary circle", "imaginary circle"]
		),
		"kinds as the plane rises"
	)


func test_three_spheres_meet_in_their_circles() -> void:
	_open("three_spheres")
	for sphere: String in ["A", "B", "C"]:
		for end: String in ["+", "-"]:
			_expect_zero("((pair %s norm(pair)) / (einf << pair)) ^ normalized(%s)" % [end, sphere])
	for circle: String in ["AB", "BC", "CA"]:
		_expect_zero("((pair + norm(pair)) / (einf << pair)) ^ normalized(%s)" % circle)


func test_a_reflection_is_its_own_inverse() -> void:
	_open("reflection")
	for shape: String in ["ball", "ring", "needle", "tip"]:
		_expect_same("reflect_in(%s_image, mirror)" % shape, shape)
	expect_near(_radius("ball_image"), _radius("ball"), EXACT, "radius")
	expect_vector_near(
		(_center_of("tip") - _center_of("tip_image")).normalized().abs(),
		Vector3(1.0, 0.0, 0.12).normalized(),
		1e-6,
		"a point and its image lie along the normal"
	)


func test_an_inversion_makes_circles_of_lines() -> void:
	_open("inversion")
	_expect_kind("floor_image", "sphere")
	for line in 5:
		for set_of: String in ["along", "across"]:
			var image := "%s_%d_image" % [set_of, line + 1]
			_expect_kind(image, "circle")
			_expect_zero("normalized(%s) ^ point(0, 1.9, 0)" % image)
			_expect_zero("reject_from(%s, floor_image)" % image)
	_scene.set_parameter("mirror", "center", Vector3(0.0, 0.0, 0.0))
	_expect_kind("floor_image", "plane")


func test_two_pencils_are_at_right_angles() -> void:
	_open("two_pencils")
	for circle in 18:
		for pole: String in ["a", "b"]:
			_expect_zero("normalized(circle_%d) ^ %s" % [circle + 1, pole])
		# Orthogonal to a sphere: the dual sphere lies in the circle's blade.
		_expect_zero("normalized(!chosen) ^ normalized(circle_%d)" % [circle + 1])
		_expect_zero("normalized(!sphere_1) ^ normalized(circle_%d)" % [circle + 1])
	_scene.set_parameter("ratio", "value", 1.0)
	_expect_kind("chosen", "plane")


func test_two_reflections_rotate_by_twice_their_angle() -> void:
	_open("turn_by_two_mirrors")
	for angle: float in [0.0, 20.0, 50.0, 75.0]:
		_scene.set_parameter("angle", "value", angle)
		_expect_zero("normalized(ring_twice) - normalized(ring_turned)")
		var rotated: float = (
			_scene.get_value("R").to_transform().basis.get_rotation_quaternion().get_angle()
		)
		expect_near(rotated, deg_to_rad(2.0 * angle), 1e-5, "rotation at %s degrees" % angle)


func test_parallel_reflections_translate_by_twice_their_distance() -> void:
	_open("shift_by_two_mirrors")
	for gap: float in [-1.0, 0.0, 0.7, 2.4]:
		_scene.set_parameter("gap", "value", gap)
		expect_vector_near(
			_scene.get_value("T").to_transform().origin,
			Vector3(2.0 * gap, 0, 0),
			1e-6,
			"translation at a gap of %s" % gap
		)
		_expect_position("ring_twice", Vector3(-2.2 + 2.0 * gap, 0.8, 0.0))


func test_the_cube_moves_between_the_poses() -> void:
	_open("cube_between_poses")
	for t: float in [0.0, 1.0]:
		_scene.set_parameter("t", "value", t)
		for edge in 12:
			_expect_zero(
				(
					"normalized(moved_%d) - normalized(%s_%d)"
					% [edge + 1, "from" if t == 0.0 else "to", edge + 1]
				)
			)
	_scene.set_parameter("t", "value", 0.5)
	# All edges have the same length, scaled by the geometric mean of both scales.
	for edge in 12:
		expect_near(
			_radius("moved_%d" % [edge + 1]),
			0.6 * sqrt(0.8 * 1.3),
			1e-6,
			"half the length of edge %d" % [edge + 1]
		)


func test_three_blends_agree_at_the_ends_only() -> void:
	_open("blending_methods")
	for t: float in [0.0, 1.0]:
		_scene.set_parameter("t", "value", t)
		for method: String in ["linear", "separate"]:
			_expect_zero("normalized(%s_body) - normalized(screw_body)" % method)
	_scene.set_parameter("t", "value", 0.5)
	expect_true(
		_center_of("separate_body").distance_to(_center_of("screw_body")) > 0.3,
		"separate and screw differ halfway"
	)
	expect_vector_near(
		_center_of("separate_body"),
		Vector3(0.0, 0.6, 0.4),
		1e-6,
		"separate moves on a straight line"
	)
	_scene.set_parameter("t", "value", 0.25)
	var distance := _center_of("linear_body").distance_to(_center_of("screw_body"))
	expect_true(distance > 0.005 and distance < 0.5, "linear stays close to screw: %s" % distance)


func test_the_shell_is_self_similar() -> void:
	_open("shell")
	for ball in range(1, 44):
		expect_near(
			_radius("ball_%d" % [ball + 1]) / _radius("ball_%d" % ball),
			0.95,
			EXACT,
			"growth of ball %d" % ball
		)
	var before := _center_of("ball_2")
	_scene.set_parameter("slide", "value", 1.0)
	expect_vector_near(
		_center_of("ball_1"), before, 1e-6, "after one step, each ball is where the next one was"
	)


func test_neighboring_balls_of_the_loxodrome_are_congruent() -> void:
	_open("loxodrome")
	var first := _scene.evaluate("normalized(!ball_1) | normalized(!ball_2)").coefficients[0]
	for ball in range(2, 46):
		var product := (
			_scene
			. evaluate("normalized(!ball_%d) | normalized(!ball_%d)" % [ball, ball + 1])
			. coefficients[0]
		)
		expect_near(product, first, EXACT, "balls %d and %d" % [ball, ball + 1])
	for pole: String in ["a", "b"]:
		_expect_same("sandwich(exp(generator), %s)" % pole, pole)


func test_the_arm_keeps_its_lengths() -> void:
	_open("robot_arm")
	for target: Vector3 in [
		Vector3(2.1, 0.6, 0.7),
		Vector3(-1.0, 0.5, -1.5),
		Vector3(0.3, -0.4, 0.2),
		Vector3(9.0, 3.0, 0.0),
		Vector3(0.0, 0.0, 2.0)
	]:
		_drag("target", target)
		expect_near(2.0 * _radius("upper_arm"), 1.7, 1e-8, "upper arm for %s" % target)
		expect_near(2.0 * _radius("lower_arm"), 1.4, 1e-8, "lower arm for %s" % target)
		expect_near(2.0 * _radius("palm"), 0.6, 1e-8, "hand for %s" % target)
		expect_true(
			_center_of("elbow").y >= _center_of("elbows").y,
			"the arm uses the upper elbow for %s" % target
		)
		var in_reach := (target + Vector3(0.0, 0.6, 0.0)).length() < 3.09
		expect_equal(_center_of("tip").distance_to(target) < 1e-5, in_reach, "reaching %s" % target)
	_drag("target", Vector3(0.0, 0.9, 0.0))
	expect_true(
		_scene.get_error("elbow").contains("division by zero"),
		"no plane straight above the shoulder: %s" % _scene.get_error("elbow")
	)


func test_apollonius_circles_touch_all_three() -> void:
	_open("apollonius")
	for i in 3:
		for solution: String in ["same", "turn_a", "turn_b", "turn_c"]:
			for number: String in ["1", "2"]:
				for given: String in ["a", "b", "c"]:
					_expect_touch("normalized(n << !%s_%s)" % [solution, number], "unit_%s" % given)
		_drag("a", Vector3(-1.6, 0.3 * i, 0.9))
		_scene.set_parameter("radius_c", "value", 0.4 + 0.1 * i)


func test_the_hexlet_closes() -> void:
	_open("hexlet")
	for turn: float in [0.0, 10.0, 37.5, 200.0]:
		_scene.set_parameter("turn", "value", turn)
		for bead in 6:
			var unit := "normalized(!bead_%d)" % [bead + 1]
			_expect_touch(unit, "normalized(!bead_%d)" % [(bead + 1) % 6 + 1])
			for sphere: String in ["outer", "lower", "inner"]:
				_expect_touch(unit, "normalized(!%s)" % sphere)


func test_hopf_circles_are_orbits_and_linked() -> void:
	_open("hopf_circles")
	for circle: String in ["thin_1", "thin_8", "wide_1", "wide_5"]:
		_expect_kind(circle, "circle")
		_expect_zero(
			"normalized(sandwich(exp(0.3 * (e13 + e24)), %s)) - normalized(%s)" % [circle, circle]
		)
	# Two circles are linked if one crosses the disc of the other once: of its two points in the
	# other's plane, one lies inside the other circle and one outside.
	for pair: String in ["thin_1/thin_5", "thin_1/wide_3", "wide_2/wide_9"]:
		var names := pair.split("/")
		var center := _center_of(names[1])
		var radius := _radius(names[1])
		var inside := 0
		for end: String in ["+", "-"]:
			var cut := "meet(%s, %s ^ einf)" % [names[0], names[1]]
			var point := _position_of(
				_scene.evaluate("(%s %s norm(%s)) / (einf << %s)" % [cut, end, cut, cut])
			)
			inside += int(point.distance_to(center) < radius)
		expect_equal(inside, 1, "crossings of %s through the disc of %s" % [names[0], names[1]])


func _open(example: String) -> void:
	_scene = Gallery.load_example(example)


func _drag(entry: String, position: Vector3) -> void:
	expect_equal(_scene.set_parameter(entry, "position", position), OK, "dragging %s" % entry)


func _kind(entry: String) -> String:
	return _scene.get_value(entry).classify()["kind"]


func _expect_kind(entry: String, kind: String) -> void:
	expect_equal(_kind(entry), kind, "kind of %s" % entry)


func _is_imaginary(entry: String) -> bool:
	return _scene.get_value(entry).classify()["imaginary"]


func _radius(entry: String) -> float:
	return _scene.get_value(entry).classify()["radius"]


func _center_of(entry: String) -> Vector3:
	return _position_of(_scene.get_value(entry))


func _position_of(value: Multivector) -> Vector3:
	var description := value.classify()
	return description["center"] if description.has("center") else description["position"]


func _expect_position(entry: String, position: Vector3) -> void:
	expect_vector_near(_center_of(entry), position, 1e-6, "position of %s" % entry)


## Expects all 32 coefficients to be zero.
func _expect_zero(expression: String) -> void:
	var value := _scene.evaluate(expression)
	if value == null:
		fail("%s has no value" % expression)
		return
	var largest := 0.0
	for coefficient in value.coefficients:
		largest = maxf(largest, absf(coefficient))
	expect_near(largest, 0.0, EXACT, expression)


## Expects two expressions to be equal up to a non-zero factor.
func _expect_same(first: String, second: String) -> void:
	var expected := _scene.evaluate(second).coefficients
	var largest := 0
	for i in 32:
		if absf(expected[i]) > absf(expected[largest]):
			largest = i
	var factor := _scene.evaluate(first).coefficients[largest] / expected[largest]
	expect_true(absf(factor) > EXACT, "%s is not zero" % first)
	_expect_zero("(%s) / (%s) - (%s)" % [first, factor, second])


## Expects two unit spheres, given as vectors, to touch: their inner product is 1 or -1.
func _expect_touch(first: String, second: String) -> void:
	expect_near(
		absf(_scene.evaluate("%s | %s" % [first, second]).coefficients[0]),
		1.0,
		EXACT,
		"%s touching %s" % [first, second]
	)
