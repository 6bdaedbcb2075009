extends "res://tests/framework/test_case.gd"
## meet, join, projection, rejection and reflection of objects, the degenerate cases among them.

const NOT_A_BLADE := (
	"the second multivector is not a blade (a nonzero outer product of vectors), so it "
	+ "represents no object"
)
const METHODS: Array[StringName] = [
	&"meet", &"join", &"project_onto", &"reject_from", &"reflect_in"
]


func test_line_and_plane() -> void:
	var ground := Multivector.plane(Vector3.UP, 1.0)
	var found := (
		ground.meet(Multivector.line_through(Vector3(2, 0, 3), Vector3(2, 5, 3))).classify()
	)
	expect_equal(found["kind"], "flat_point")
	expect_vector_near(found["center"] as Vector3, Vector3(2, 1, 3), 1e-6)
	# A line in the plane meets it in the line, a parallel line in their common direction.
	var inside := Multivector.line(Vector3(0, 1, 0), Vector3.RIGHT)
	expect_equal(ground.meet(inside).classify()["kind"], "line")
	expect_equal(
		ground.meet(Multivector.line(Vector3.ZERO, Vector3.RIGHT)).classify()["kind"], "direction"
	)


func test_lines() -> void:
	var a := Multivector.line(Vector3(0, 0, 2), Vector3.RIGHT)
	var crossing := Multivector.line(Vector3(3, 0, 2), Vector3.UP)
	_expect_kinds(a, crossing, "flat_point", "plane")
	expect_vector_near(a.meet(crossing).classify()["center"] as Vector3, Vector3(3, 0, 2), 1e-6)
	_expect_kinds(a, Multivector.line(Vector3(0, 4, 2), Vector3.RIGHT), "direction", "plane")
	_expect_kinds(a, a.scaled(-3.0), "line", "line")
	# Skew lines have the point at infinity in common, and span everything.
	var skew := Multivector.line(Vector3(0, 1, 0), Vector3.UP + Vector3.BACK)
	expect_coefficients(
		a.join(skew).grade(5).subtract(a.join(skew)), {}, 1e-12, "all but grade 5 of the join"
	)


func test_spheres_and_circles() -> void:
	var sphere := Multivector.sphere(Vector3.ZERO, 2.0)
	var cut := sphere.meet(Multivector.plane(Vector3.UP, 1.0)).classify()
	expect_equal(cut["kind"], "circle")
	expect_near(cut["radius"] as float, sqrt(3.0), 1e-9)
	expect_equal(cut["imaginary"], false)
	var missed := sphere.meet(Multivector.plane(Vector3.UP, 3.0)).classify()
	expect_equal(missed["imaginary"], true)
	expect_near(missed["radius"] as float, sqrt(5.0), 1e-9)
	expect_equal(sphere.meet(Multivector.plane(Vector3.UP, 2.0)).classify()["kind"], "tangent")
	# Coplanar circles meet in a pair: real if they cross, imaginary if they are apart.
	var circle := Multivector.circle(Vector3.ZERO, Vector3.UP, 2.0)
	var crossed := circle.meet(Multivector.circle(Vector3(2, 0, 0), Vector3.UP, 2.0)).classify()
	expect_equal(crossed["kind"], "point_pair")
	expect_equal(crossed["imaginary"], false)
	expect_equal(
		circle.meet(Multivector.circle(Vector3(9, 0, 0), Vector3.UP, 1.0)).classify()["imaginary"],
		true
	)
	expect_equal(circle.meet(circle).classify()["kind"], "circle")


func test_join_of_points() -> void:
	var a := Multivector.point(Vector3(1, 0, 0))
	var b := Multivector.point(Vector3(0, 2, 0))
	expect_equal(a.join(b).classify()["kind"], "point_pair")
	expect_equal(a.join(a).classify()["kind"], "point")
	expect_equal(Multivector.line(Vector3.ZERO, Vector3.RIGHT).join(b).classify()["kind"], "plane")


func test_projection_and_rejection() -> void:
	var foot := (
		Multivector
		. flat_point(Vector3(1, 5, 2))
		. project_onto(Multivector.plane(Vector3.UP, 1.0))
		. classify()
	)
	expect_vector_near(foot["center"] as Vector3, Vector3(1, 1, 2), 1e-6)
	var vector := Multivector.evaluate("e1 + e3")
	expect_coefficients(vector.project_onto(Multivector.basis("e12")), {1: 1.0})
	expect_coefficients(vector.reject_from(Multivector.basis("e12")), {3: 1.0})


func test_reflection() -> void:
	var sphere := Multivector.sphere(Vector3(4, 3, 0), 0.5)
	var image := sphere.reflect_in(Multivector.plane(Vector3.UP, 1.0)).classify()
	expect_vector_near(image["center"] as Vector3, Vector3(4, -1, 0), 1e-6)
	expect_near(image["radius"] as float, 0.5, 1e-9)
	expect_vector_near(
		(
			sphere.reflect_in(Multivector.line(Vector3.ZERO, Vector3.UP)).classify()["center"]
			as Vector3
		),
		Vector3(-4, 3, 0),
		1e-6
	)
	# Inversion in a sphere: the product of the distances from its center is the squared radius.
	var inverted := (
		Multivector
		. point(Vector3(4, 0, 0))
		. reflect_in(Multivector.sphere(Vector3.ZERO, 2.0))
		. classify()
	)
	expect_vector_near(inverted["center"] as Vector3, Vector3(1, 0, 0), 1e-6)


func test_operands_that_are_not_blades_are_errors() -> void:
	var sphere := Multivector.sphere(Vector3.ZERO, 2.0)
	var before := sphere.coefficients
	for method in METHODS:
		expect_error("Multivector.%s: the other multivector is null." % method)
		expect_null(sphere.call(method, null) as Multivector, method)
		expect_error("Multivector.%s: %s." % [method, NOT_A_BLADE])
		expect_null(sphere.call(method, Multivector.evaluate("e12 + e34")) as Multivector, method)
	expect_equal(sphere.coefficients, before, "the operand")


func _expect_kinds(a: Multivector, b: Multivector, meet: String, join: String) -> void:
	expect_equal(a.meet(b).classify()["kind"], meet, "kind of the meet")
	expect_equal(a.join(b).classify()["kind"], join, "kind of the join")
