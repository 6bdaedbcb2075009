extends "res://tests/framework/test_case.gd"
## Geometric objects: constructors and their errors, and classify() in both conventions.

const NOT_FINITE := "a coefficient or coordinate is not finite; pass finite numbers"
const COINCIDENT := "two of the points coincide; pass distinct points"
const NO_DIRECTION := "the direction or normal is zero; pass a vector of any other length"
const NO_NORMAL := "the direction or normal is zero; pass a vector of any other length"
const NO_RADIUS := "the radius must be a finite number above zero"
const COLLINEAR := (
	"the points are collinear, so they define no single plane; pass the corners of a " + "triangle"
)
const CONCYCLIC := (
	"the points lie on one circle or line, so they define no single sphere; pass four that "
	+ "do not"
)

const LENGTHS := [0.001, 1.0, 1000.0]


func test_classify_returns_what_objects_were_made_from() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 21
	for i in 200:
		var size: float = LENGTHS[i % 3]
		var a := _random(generator) * size
		var b := _random(generator) * size
		var normal := _random(generator).normalized()
		var radius := generator.randf_range(0.1, 3.0) * size
		var near := 1e-5 * size
		_expect_class(Multivector.point(a), "point", {"center": a}, near)
		_expect_class(Multivector.flat_point(a), "flat_point", {"center": a}, near)
		_expect_class(
			Multivector.point_pair(a, b),
			"point_pair",
			{
				"center": (a + b) / 2.0,
				"radius": a.distance_to(b) / 2.0,
				"direction": (b - a).normalized()
			},
			near
		)
		_expect_class(Multivector.line(a, normal * 3.0), "line", {"direction": normal}, near)
		_expect_class(
			Multivector.line_through(a, b), "line", {"direction": (b - a).normalized()}, near
		)
		_expect_class(
			Multivector.circle(a, normal * 2.0, radius),
			"circle",
			{"center": a, "radius": radius, "normal": normal},
			near
		)
		_expect_class(
			Multivector.plane(normal * 5.0, radius),
			"plane",
			{"normal": normal, "distance": radius},
			near
		)
		_expect_class(
			Multivector.sphere(a, radius), "sphere", {"center": a, "radius": radius}, near
		)


func test_objects_through_points_contain_them() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 22
	for i in 200:
		var points: Array[Vector3] = []
		for k in 4:
			points.append(_random(generator))
		_expect_on(Multivector.point_pair(points[0], points[1]), points.slice(0, 2))
		_expect_on(Multivector.line_through(points[0], points[1]), points.slice(0, 2))
		_expect_on(Multivector.circle_through(points[0], points[1], points[2]), points.slice(0, 3))
		_expect_on(Multivector.plane_through(points[0], points[1], points[2]), points.slice(0, 3))
		_expect_on(Multivector.sphere_through(points[0], points[1], points[2], points[3]), points)


func test_points_of_a_pair() -> void:
	var found := Multivector.point_pair(Vector3(1, 2, 3), Vector3(1, 6, 3)).classify()
	var points: Array = found["points"]
	expect_vector_near(points[0] as Vector3, Vector3(1, 2, 3), 1e-6)
	expect_vector_near(points[1] as Vector3, Vector3(1, 6, 3), 1e-6)


func test_weight_and_sign_do_not_change_the_object() -> void:
	for weight: float in [-1.0, 1e-6, 3e5]:
		var found := Multivector.sphere(Vector3(1, 2, 3), 0.5).scaled(weight).classify()
		expect_equal(found["kind"], "sphere")
		expect_near(found["radius"] as float, 0.5, 1e-9)


func test_degenerate_points_give_a_flat_and_a_warning() -> void:
	expect_warning(
		(
			"Multivector.circle_through: the points are collinear, so the result is the "
			+ "line through them."
		)
	)
	var line := Multivector.circle_through(Vector3(0, 1, 0), Vector3(1, 1, 0), Vector3(5, 1, 0))
	_expect_class(line, "line", {}, 0.0)
	_expect_on(line, [Vector3(0, 1, 0), Vector3(1, 1, 0), Vector3(5, 1, 0), Vector3(-7, 1, 0)])
	expect_warning(
		(
			"Multivector.sphere_through: the points are coplanar, so the result is the "
			+ "plane through them."
		)
	)
	var plane := Multivector.sphere_through(
		Vector3(0, 2, 0), Vector3(1, 2, 0), Vector3(0, 2, 1), Vector3(3, 2, 3)
	)
	_expect_class(plane, "plane", {}, 0.0)
	_expect_on(plane, [Vector3(-5, 2, 9)])


func test_constructors_reject_invalid_arguments() -> void:
	var a := Vector3(1, 2, 3)
	var b := Vector3(4, 5, 7)
	var bad := Vector3(0, NAN, 0)
	var cases: Dictionary[StringName, Dictionary] = {
		&"flat_point": {NOT_FINITE: [[bad]]},
		&"point_pair": {COINCIDENT: [[a, a]], NOT_FINITE: [[a, bad]]},
		&"line": {NO_DIRECTION: [[a, Vector3.ZERO]], NOT_FINITE: [[bad, a], [a, bad]]},
		&"line_through": {COINCIDENT: [[a, a]], NOT_FINITE: [[bad, a]]},
		&"circle":
		{
			NO_NORMAL: [[a, Vector3.ZERO, 1.0]],
			NO_RADIUS: [[a, b, 0.0], [a, b, -1.0], [a, b, NAN]],
			NOT_FINITE: [[bad, b, 1.0], [a, bad, 1.0]]
		},
		&"circle_through": {COINCIDENT: [[a, a, b], [a, b, b]], NOT_FINITE: [[a, b, bad]]},
		&"plane": {NO_NORMAL: [[Vector3.ZERO, 1.0]], NOT_FINITE: [[a, INF], [bad, 1.0]]},
		&"plane_through":
		{
			COLLINEAR: [[a, a, b], [Vector3.ZERO, Vector3.RIGHT, Vector3(3, 0, 0)]],
			NOT_FINITE: [[a, b, bad]]
		},
		&"sphere": {NO_RADIUS: [[a, 0.0], [a, -2.0], [a, INF]], NOT_FINITE: [[bad, 1.0]]},
		&"sphere_through":
		{
			COINCIDENT: [[a, a, b, Vector3.ZERO]],
			NOT_FINITE: [[a, b, Vector3.ZERO, bad]],
			CONCYCLIC: [[Vector3.RIGHT, Vector3.UP, Vector3.LEFT, Vector3.DOWN]]
		},
	}
	var multivector := Multivector.new()
	for method in cases:
		for reason: String in cases[method]:
			for arguments: Array in cases[method][reason]:
				expect_error("Multivector.%s: %s." % [method, reason])
				expect_null(
					multivector.callv(method, arguments) as Multivector,
					"%s%s" % [method, arguments]
				)


func test_classify_elements_without_a_center() -> void:
	expect_equal(Multivector.scalar(3.0).classify()["kind"], "scalar")
	expect_equal(Multivector.basis("einf").classify()["kind"], "direction")
	expect_equal(Multivector.evaluate("e1 ^ einf").classify()["kind"], "direction")
	expect_equal(Multivector.evaluate("e12 + e34").classify()["kind"], "none")
	expect_true(
		(Multivector.evaluate("e12 + e34").classify()["residual"] as float) > 0.1,
		"a residual of an element that is not a blade"
	)
	expect_true(not Multivector.scalar(3.0).classify().has("center"), "no center of a scalar")


func test_classify_versors() -> void:
	expect_equal(Multivector.rotor(Quaternion(Vector3.UP, 1.0)).classify()["kind"], "rotor")
	expect_equal(Multivector.translator(Vector3.ONE).classify()["kind"], "translator")
	expect_equal(Multivector.dilator(2.0).classify()["kind"], "dilator")
	expect_equal(
		Multivector.motor_from(Vector3.ONE, Quaternion(Vector3.UP, 1.0), 2.0).classify()["kind"],
		"motor"
	)


func test_imaginary_rounds() -> void:
	# The dual sphere of squared radius -4.
	var found := (
		Multivector
		. point(Vector3(1, 2, 3))
		. add(Multivector.basis("einf").scaled(2.0))
		. classify(true)
	)
	expect_equal(found["kind"], "sphere")
	expect_equal(found["imaginary"], true)
	expect_near(found["radius"] as float, 2.0, 1e-12)
	expect_equal(Multivector.sphere(Vector3.ONE, 2.0).classify()["imaginary"], false)


func test_classify_returns_no_nan() -> void:
	# Of any kind. (Coefficients beyond the range of doubles are an error and "none".)
	var generator := RandomNumberGenerator.new()
	generator.seed = 23
	for i in 500:
		var element := Multivector.basis_blade(generator.randi_range(1, 30)).scaled(
			pow(10.0, generator.randi_range(-30, 30))
		)
		element = element.add(
			Multivector.basis_blade(generator.randi_range(1, 30)).scaled(
				pow(10.0, generator.randi_range(-30, 30))
			)
		)
		for ipns: bool in [false, true]:
			var found := element.classify(ipns)
			expect_true(
				not str(found).contains("nan") and not str(found).contains("inf,"),
				"%s of %s" % [found, element.to_text()]
			)


## Checks the object in OPNS and its dual in IPNS.
func _expect_class(object: Multivector, kind: String, parts: Dictionary, tolerance: float) -> void:
	for ipns: bool in [false, true]:
		var found := (object.dual() if ipns else object).classify(ipns)
		expect_equal(found["kind"], kind, "kind (ipns %s)" % ipns)
		expect_equal(found["ipns"], ipns, "ipns")
		for key: String in parts:
			if parts[key] is Vector3:
				var unit := key in ["normal", "direction"]
				expect_vector_near(
					found[key] as Vector3,
					parts[key] as Vector3,
					1e-5 if unit else tolerance,
					"%s of a %s" % [key, kind]
				)
			else:
				expect_near(
					found[key] as float, parts[key] as float, tolerance, "%s of a %s" % [key, kind]
				)


func _expect_on(object: Multivector, points: Array[Vector3]) -> void:
	for point in points:
		var distance := Multivector.point(point).outer_product(object)
		var size := 1e-9 * maxf(1.0, _largest(object)) * (1.0 + point.length_squared())
		expect_coefficients(distance, {}, size, "X ^ A of a point on it")


func _largest(multivector: Multivector) -> float:
	var largest := 0.0
	for number in multivector.coefficients:
		largest = maxf(largest, absf(number))
	return largest


func _random(generator: RandomNumberGenerator) -> Vector3:
	return Vector3(generator.randfn(), generator.randfn(), generator.randfn())
