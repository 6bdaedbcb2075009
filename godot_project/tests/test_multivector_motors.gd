extends "res://tests/framework/test_case.gd"
## Multivector as a versor: translators, rotors, dilators and motors, and their parts.

const Poses := preload("res://tests/framework/poses.gd")

const INVALID_TRANSFORMS: Dictionary[String, Transform3D] = {
	"has a value that is not finite (NaN or infinity); check where it was computed":
	Transform3D(Vector3(NAN, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3.ZERO),
	"has zero scale along an axis; a motor needs a positive scale":
	Transform3D(Vector3(1, 0, 0), Vector3(0, 0, 0), Vector3(0, 0, 1), Vector3.ZERO),
	"is mirrored (negative scale), which a motor cannot represent; mirror a child node instead":
	Transform3D(Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3.ZERO),
	"has non-uniform scale or shear; a motor has one uniform scale, so scale a child node instead":
	Transform3D(Vector3(1, 0, 0), Vector3(0, 2, 0), Vector3(0, 0, 1), Vector3.ZERO),
}
const NOT_A_MOTOR := (
	"Multivector.%s: this multivector is not a motor with a positive scale, so it "
	+ "has no transform."
)


func test_point() -> void:
	# p + p^2/2 einf + eo.
	expect_coefficients(
		Multivector.point(Vector3(1, 2, 3)), {1: 1.0, 2: 2.0, 3: 3.0, 4: 6.5, 5: 7.5}
	)
	expect_error("Multivector.point: the position is not finite.")
	expect_null(Multivector.point(Vector3(INF, 0, 0)))


func test_translator() -> void:
	# 1 - t einf / 2.
	expect_coefficients(
		Multivector.translator(Vector3(2, -4, 6)),
		{0: 1.0, 8: -1.0, 9: -1.0, 11: 2.0, 12: 2.0, 13: -3.0, 14: -3.0}
	)
	expect_error("Multivector.translator: the offset is not finite.")
	expect_null(Multivector.translator(Vector3(0, NAN, 0)))


func test_rotor() -> void:
	# w - z e12 + y e13 - x e23, exact in single precision.
	expect_coefficients(
		Multivector.rotor(Quaternion(0.5, -0.5, 0.5, 0.5)), {0: 0.5, 6: -0.5, 7: -0.5, 10: -0.5}
	)
	var zero := (
		"Multivector.rotor: the quaternion is zero or not finite; for no rotation, use "
		+ "Quaternion.IDENTITY."
	)
	expect_error(zero, 2)
	expect_null(Multivector.rotor(Quaternion(0, 0, 0, 0)))
	expect_null(Multivector.rotor(Quaternion(NAN, 0, 0, 1)))


func test_dilator() -> void:
	# cosh(g/2) - sinh(g/2) e45 with exp(g) = 4: 1.25 and 0.75.
	expect_coefficients(Multivector.dilator(4.0), {0: 1.25, 15: -0.75})
	expect_error("Multivector.dilator: the scale must be positive and finite, not %f." % 0.0)
	expect_null(Multivector.dilator(0.0))
	expect_error("Multivector.dilator: the scale must be positive and finite, not %f." % -2.0)
	expect_null(Multivector.dilator(-2.0))


func test_a_motor_is_translator_times_rotor_times_dilator() -> void:
	var translation := Vector3(1, -2, 3)
	var rotation := Quaternion(Vector3(1, 2, -1).normalized(), 1.3)
	var motor := Multivector.motor_from(translation, rotation, 2.0)
	var product := (
		Multivector
		. translator(translation)
		. geometric_product(Multivector.rotor(rotation))
		. geometric_product(Multivector.dilator(2.0))
	)
	expect_true(motor.is_equal_approx(product), "equality of motor_from and the product T R D")
	expect_true(motor.is_motor(), "is_motor of a motor")


func test_degenerate_transforms_survive_a_round_trip() -> void:
	var poses := Poses.degenerate()
	for title: String in poses:
		var pose: Transform3D = poses[title]
		var size := maxf(pose.basis.x.length(), pose.origin.length())
		expect_transform_near(
			Multivector.motor(pose).to_transform(), pose, 3e-7 * maxf(1.0, size), title
		)


func test_random_transforms_survive_a_round_trip() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 1
	for i in 500:
		var pose := Poses.random(generator)
		expect_transform_near(Multivector.motor(pose).to_transform(), pose, 4e-6)


func test_parts_of_a_motor_of_any_weight() -> void:
	var translation := Vector3(1.5, -2.25, 3.0)
	var rotation := Quaternion(Vector3(3, -1, 2).normalized(), 2.0)
	for weight: float in [1.0, -1.0, 250.0, -0.004]:
		var motor := Multivector.motor_from(translation, rotation, 0.75).scaled(weight)
		expect_vector_near(
			motor.get_translation(), translation, 1e-6, "translation at weight %s" % weight
		)
		expect_near(
			absf(motor.get_rotation().dot(rotation)), 1.0, 1e-6, "rotation at weight %s" % weight
		)
		expect_near(motor.get_scale(), 0.75, 1e-12, "scale at weight %s" % weight)


func test_q_and_minus_q_are_the_same_pose() -> void:
	var rotation := Quaternion(0.5, 0.5, -0.5, 0.5)
	var one := Multivector.motor_from(Vector3(1, 2, 3), rotation, 2.0).to_transform()
	var other := Multivector.motor_from(Vector3(1, 2, 3), -rotation, 2.0).to_transform()
	expect_transform_near(one, other, 1e-7)


func test_motor_from_normalizes_the_rotation_and_rejects_invalid_arguments() -> void:
	var motor := Multivector.motor_from(Vector3.ZERO, Quaternion(0, 0, 0, 7.0), 1.0)
	expect_coefficients(motor, {0: 1.0})
	expect_error("Multivector.motor_from: the translation is not finite.")
	expect_null(Multivector.motor_from(Vector3(NAN, 0, 0), Quaternion.IDENTITY, 1.0))
	expect_error(
		(
			"Multivector.motor_from: the rotation is zero or not finite; for no rotation, "
			+ "use Quaternion.IDENTITY."
		)
	)
	expect_null(Multivector.motor_from(Vector3.ZERO, Quaternion(0, 0, 0, 0), 1.0))
	expect_error("Multivector.motor_from: the scale must be positive and finite, not %f." % -1.0)
	expect_null(Multivector.motor_from(Vector3.ZERO, Quaternion.IDENTITY, -1.0))


func test_motor_rejects_invalid_transforms() -> void:
	for reason: String in INVALID_TRANSFORMS:
		expect_error("Multivector.motor: the transform %s." % reason)
		expect_null(Multivector.motor(INVALID_TRANSFORMS[reason]), reason)


func test_sandwich_agrees_with_the_transform() -> void:
	var pose := Poses.make(Vector3(1, -2, 3), Quaternion(Vector3(1, 1, 0).normalized(), 0.8), 1.6)
	var motor := Multivector.motor(pose)
	var point := Vector3(0.5, 4.0, -2.0)
	expect_vector_near(motor.transform_point(point), pose * point, 1e-5, "transform_point")
	# The image of a point is a point of some weight, which is -image . einf.
	var image := motor.sandwich(Multivector.point(point))
	var weight := -image.scalar_product(Multivector.basis("einf"))
	var numbers := image.scaled(1.0 / weight).coefficients
	expect_vector_near(Vector3(numbers[1], numbers[2], numbers[3]), pose * point, 1e-5, "sandwich")
	expect_coefficients(image.subtract(image.grade(1)), {}, 1e-9, "the part that is not a vector")


func test_only_versors_transform() -> void:
	var mixed := Multivector.scalar(1.0).add(Multivector.basis("e1").scaled(2.0))
	expect_error(
		(
			"Multivector.sandwich: this multivector is not a versor (even or odd, with an "
			+ "inverse), so it cannot transform anything."
		)
	)
	expect_null(mixed.sandwich(Multivector.basis("e2")))


func test_a_multivector_that_is_not_a_motor_has_no_transform() -> void:
	var plane := Multivector.basis("e1")
	expect_equal(plane.is_motor(), false, "is_motor of e1")
	expect_error(NOT_A_MOTOR % "to_transform")
	expect_equal(plane.to_transform(), Transform3D.IDENTITY)
	expect_error(NOT_A_MOTOR % "get_translation")
	expect_equal(plane.get_translation(), Vector3.ZERO)
	expect_error(NOT_A_MOTOR % "get_rotation")
	expect_equal(plane.get_rotation(), Quaternion.IDENTITY)
	expect_error(NOT_A_MOTOR % "get_scale")
	expect_equal(plane.get_scale(), 1.0)
	expect_error(NOT_A_MOTOR % "transform_point")
	expect_equal(plane.transform_point(Vector3.ONE), Vector3.ONE)


func test_transform_point_rejects_nan() -> void:
	expect_error("Multivector.transform_point: the point is not finite.")
	var point := Multivector.translator(Vector3.ONE).transform_point(Vector3(INF, 0, 0))
	expect_equal(point, Vector3(INF, 0, 0))
