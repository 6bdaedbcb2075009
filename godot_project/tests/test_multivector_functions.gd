extends "res://tests/framework/test_case.gd"
## Functions of one multivector: norms, inverse, exponential, logarithm, powers, and the predicates
## is_blade, is_versor and is_motor.

const Poses := preload("res://tests/framework/poses.gd")

const E1 := 1
const E3 := 3
const E5 := 5
const E12 := 6
const E45 := 15

const NULL_ELEMENT := (
	"the multivector is null (its norm is zero), so no multiple of it has norm 1; scale null "
	+ "objects by their meaning: a point to -e_inf . X = 1"
)
const SINGULAR := (
	"the multivector has no inverse: it is null or a zero divisor, or too close to one for "
	+ "double precision"
)
const ODD := (
	"an odd versor (a reflection or inversion) has no logarithm: no continuous motion "
	+ "reaches it"
)
const NOT_A_VERSOR := (
	"the multivector is not a versor (a product of non-null vectors), or rounding has erased "
	+ "its norm; normalized() turns a noisy one into a versor"
)


func test_norms() -> void:
	expect_near(Multivector.basis("e12").scaled(-3.0).norm(), 3.0, 1e-15)
	expect_near(Multivector.basis("e1").scaled(2.0).norm_squared(), 4.0, 1e-15)
	expect_near(Multivector.basis("e5").norm_squared(), -1.0, 0.0)
	expect_near(Multivector.basis("eo").norm(), 0.0, 0.0)
	var huge := Multivector.scalar(1e200)
	expect_error("Multivector.norm: the result is beyond the range of 64-bit floats.")
	expect_equal(huge.norm(), 0.0)
	expect_error("Multivector.norm_squared: the result is beyond the range of 64-bit floats.")
	expect_equal(huge.norm_squared(), 0.0)


func test_normalized() -> void:
	expect_coefficients(Multivector.basis("e1").scaled(-4.0).normalized(), {E1: -1.0}, 1e-15)
	expect_coefficients(Multivector.basis("e5").scaled(1e150).normalized(), {E5: 1.0}, 1e-15)
	expect_coefficients(Multivector.scalar(1e-200).normalized(), {0: 1.0}, 1e-15)


func test_normalized_repairs_a_noisy_motor() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 5
	for i in 200:
		var pose := Poses.random(generator)
		var motor := Multivector.motor(pose)
		var numbers := motor.coefficients
		for k in 32:
			# Even grades only, as in a blend of motors: 0, 2 and 4.
			if k == 0 or (k >= E12 and k <= E45) or (k >= 26 and k <= 30):
				numbers[k] += generator.randf_range(-1e-6, 1e-6)
		motor.coefficients = numbers
		var repaired := motor.normalized()
		expect_coefficients(repaired.geometric_product(repaired.reverse()), {0: 1.0}, 1e-9, "X X~")


func test_normalized_rejects_null_elements() -> void:
	for element: Multivector in [
		Multivector.point(Vector3(1, 2, 3)), Multivector.basis("einf"), Multivector.basis("eo")
	]:
		expect_error("Multivector.normalized: %s." % NULL_ELEMENT)
		expect_null(element.normalized())
	expect_error("Multivector.normalized: zero cannot be normalized: no multiple of it has norm 1.")
	expect_null(Multivector.new().normalized())


func test_inverse_of_versors() -> void:
	expect_coefficients(Multivector.basis("e5").inverse(), {E5: -1.0})
	expect_coefficients(Multivector.basis("e12").scaled(2.0).inverse(), {E12: -0.5})
	var motor := Multivector.motor_from(Vector3(3, -1, 2), Quaternion(0.3, -0.5, 0.1, 0.8), 2.5)
	expect_coefficients(
		motor.geometric_product(motor.inverse()), {0: 1.0}, 1e-12, "M times its inverse"
	)
	expect_coefficients(
		motor.inverse().geometric_product(motor), {0: 1.0}, 1e-12, "inverse times M"
	)


func test_inverse_of_any_element() -> void:
	# (2 + e1)(2 - e1) = 3.
	expect_coefficients(_sum({0: 2.0, E1: 1.0}).inverse(), {0: 2.0 / 3.0, E1: -1.0 / 3.0}, 1e-15)
	var generator := RandomNumberGenerator.new()
	generator.seed = 6
	for i in 200:
		var element := Multivector.new()
		var numbers := PackedFloat64Array()
		for k in 32:
			numbers.append(generator.randfn())
		element.coefficients = numbers
		var inverse := element.inverse()
		var tolerance := 1e-11 * (1.0 + _largest(inverse))
		expect_coefficients(
			element.geometric_product(inverse), {0: 1.0}, tolerance, "X times its inverse"
		)
		expect_coefficients(
			inverse.geometric_product(element), {0: 1.0}, tolerance, "inverse times X"
		)


func test_singular_elements_have_no_inverse() -> void:
	expect_error("Multivector.inverse: zero has no inverse.")
	expect_null(Multivector.new().inverse())
	# A null vector, a point, a zero divisor: (1 + e1)(1 - e1) = 0.
	for element: Multivector in [
		Multivector.basis("eo"), Multivector.point(Vector3(1, 2, 3)), _sum({0: 1.0, E1: 1.0})
	]:
		expect_error("Multivector.inverse: %s." % SINGULAR)
		expect_null(element.inverse())


func test_exp_of_bivectors() -> void:
	expect_coefficients(Multivector.new().exp(), {0: 1.0}, 0.0)
	expect_coefficients(Multivector.basis("e12").scaled(-PI / 2.0).exp(), {E12: -1.0}, 1e-15)
	expect_coefficients(
		Multivector.basis("e45").scaled(-log(4.0) / 2.0).exp(), {0: 1.25, E45: -0.75}, 1e-15
	)
	var translation := Multivector.basis("e1").outer_product(Multivector.basis("einf")).scaled(-1.5)
	expect_true(
		translation.exp().is_equal_approx(Multivector.translator(Vector3(3, 0, 0))),
		"exp(-t einf / 2) is the translator"
	)


func test_exp_of_other_elements() -> void:
	expect_coefficients(Multivector.scalar(1.0).exp(), {0: exp(1.0)}, 1e-15)
	# e1^2 = 1, so that exp(e1) = cosh 1 + sinh 1 e1.
	expect_coefficients(Multivector.basis("e1").exp(), {0: cosh(1.0), E1: sinh(1.0)}, 1e-14)
	expect_error(
		"Multivector.exp: the exponential is outside the range of double; use smaller coefficients."
	)
	expect_null(Multivector.scalar(1000.0).exp())


func test_exp_inverts_log() -> void:
	var poses := Poses.degenerate()
	var generator := RandomNumberGenerator.new()
	generator.seed = 7
	for i in 200:
		poses["random %d" % i] = Poses.random(generator)
	for title: String in poses:
		var motor := Multivector.motor(poses[title])
		var same := motor.log().exp()
		# log is that of M or -M, whichever has the smaller rotation.
		if same.scalar_product(motor.reverse()) < 0.0:
			same = same.scaled(-1.0)
		expect_true(same.is_equal_approx(motor), "exp(log(M)) is M: %s" % title)


func test_log_of_special_motors() -> void:
	# A pure translation, the identity, a rotation by pi, and a motor and its negative.
	expect_coefficients(Multivector.translator(Vector3(0, 0, 4)).log(), {13: -2.0, 14: -2.0}, 1e-15)
	expect_coefficients(Multivector.scalar(1.0).log(), {}, 0.0)
	expect_coefficients(Multivector.basis("e12").log(), {E12: PI / 2.0}, 1e-15)
	var motor := Multivector.motor_from(Vector3(1, 2, 3), Quaternion(Vector3.UP, 2.0), 1.5)
	expect_true(
		motor.log().is_equal_approx(motor.scaled(-1.0).log()),
		"equality of the logarithms of M and -M"
	)


func test_log_rejects_what_has_none() -> void:
	expect_error("Multivector.log: zero has no logarithm.")
	expect_null(Multivector.new().log())
	expect_error("Multivector.log: %s." % ODD)
	expect_null(Multivector.basis("e1").log())
	expect_error("Multivector.log: %s." % NOT_A_VERSOR)
	expect_null(_sum({0: 1.0, E1: 2.0}).log())
	expect_error(
		(
			"Multivector.sqrt: an odd versor, or an even one with negative M M~, has integer "
			+ "powers only: no continuous motion reaches it."
		)
	)
	expect_null(Multivector.basis("e1").sqrt())


func test_sqrt_and_power_of_motors() -> void:
	var motor := Multivector.motor_from(
		Vector3(1, -2, 3), Quaternion(Vector3(1, 2, 2) / 3.0, 2.5), 0.4
	)
	var half := motor.sqrt()
	expect_true(half.geometric_product(half).is_equal_approx(motor), "the square of the root is M")
	expect_true(motor.power(0.5).is_equal_approx(half), "power 1/2 is the root")
	var third := motor.power(1.0 / 3.0)
	expect_true(
		third.geometric_product(third).geometric_product(third).is_equal_approx(motor),
		"the cube of power 1/3 is M"
	)
	expect_true(motor.power(-1.0).is_equal_approx(motor.inverse()), "power -1 is the inverse")
	expect_coefficients(motor.power(0.0), {0: 1.0}, 1e-15)


func test_reflections_have_integer_powers_only() -> void:
	expect_coefficients(Multivector.basis("e1").power(3.0), {E1: 1.0}, 1e-15)
	expect_coefficients(Multivector.basis("e5").power(-1.0), {E5: -1.0}, 1e-15)
	expect_error(
		(
			"Multivector.power: an odd versor, or an even one with negative M M~, has "
			+ "integer powers only: no continuous motion reaches it."
		)
	)
	expect_null(Multivector.basis("e1").power(0.5))
	for exponent: float in [NAN, INF]:
		expect_error("Multivector.power: the exponent is not finite.")
		expect_null(Multivector.scalar(1.0).power(exponent))


func test_is_blade() -> void:
	for name: String in ["1", "e3", "e12", "e345", "e1245", "I", "eo"]:
		expect_true(Multivector.basis(name).is_blade(), "%s is a blade" % name)
	expect_true(_sum({E12: 1.0, 7: 1.0}).is_blade(), "e12 + e13 is a blade")
	expect_true(not _sum({E12: 1.0, 13: 1.0}).is_blade(), "e12 + e34 is not a blade")
	expect_true(not _sum({E1: 1.0, E12: 1.0}).is_blade(), "e1 + e12 is not a blade")


func test_is_versor() -> void:
	var motor := Multivector.motor_from(Vector3(1, 2, 3), Quaternion(Vector3.UP, 1.0), 2.0)
	for versor: Multivector in [
		motor,
		motor.scaled(-3.0),
		Multivector.basis("e1"),
		Multivector.basis("e12"),
		Multivector.scalar(2.0)
	]:
		expect_true(versor.is_versor(), "%s is a versor" % versor.to_text())
	for element: Multivector in [
		Multivector.new(),
		Multivector.basis("eo"),
		_sum({0: 1.0, E1: 2.0}),
		Multivector.point(Vector3.ONE)
	]:
		expect_true(not element.is_versor(), "%s is not a versor" % element.to_text())


func test_is_motor() -> void:
	expect_true(Multivector.dilator(0.01).scaled(-2.0).is_motor(), "a dilator is a motor")
	for element: Multivector in [
		Multivector.new(),
		Multivector.basis("e1"),
		Multivector.basis("e45"),
		_sum({0: 1.0, E3: 1.0})
	]:
		expect_true(not element.is_motor(), "%s is not a motor" % element.to_text())


func test_functions_change_no_operand() -> void:
	var motor := Multivector.motor_from(Vector3(1, 2, 3), Quaternion(Vector3.UP, 1.0), 2.0)
	var before := motor.coefficients
	for method: StringName in [
		&"normalized", &"inverse", &"exp", &"log", &"sqrt", &"reverse", &"dual"
	]:
		var result: Multivector = motor.call(method)
		expect_true(result != null and result != motor, "a new object of %s" % method)
		expect_equal(motor.coefficients, before, "operand of %s" % method)


func _sum(numbers: Dictionary[int, float]) -> Multivector:
	var coefficients := PackedFloat64Array()
	coefficients.resize(32)
	for index in numbers:
		coefficients[index] = numbers[index]
	var multivector := Multivector.new()
	multivector.coefficients = coefficients
	return multivector


func _largest(multivector: Multivector) -> float:
	var largest := 0.0
	for number in multivector.coefficients:
		largest = maxf(largest, absf(number))
	return largest
