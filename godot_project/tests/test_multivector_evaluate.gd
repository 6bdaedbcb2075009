extends "res://tests/framework/test_case.gd"
## Multivector.evaluate: values of expressions, types of variables, and error messages.

const INVALID_EXPRESSIONS: Dictionary[String, String] = {
	"": "column 1: expected a number, a name or '(', found the end",
	"1 +": "column 4: expected a number, a name or '(', found the end",
	"2 e12 + x": "column 9: unknown name 'x'",
	"foo(1)": "column 1: unknown function 'foo'",
	"1/0": "column 2: division by zero",
	"e1 $ e2": "column 4: expected a number, a name or an operator, found '$'",
	"(1": "column 3: expected ')' or an operator, found the end; the '(' at column 1 is not closed",
	"log(e1)":
	(
		"column 1: log: an odd versor (a reflection or inversion) has no logarithm: no "
		+ "continuous motion reaches it"
	),
	"1e400": "column 1: the number is too large; at most 1.8e308 is accepted",
}

const TOO_DEEP := "the expression is nested too deeply; at most 256 levels are accepted"


func test_operators() -> void:
	expect_coefficients(Multivector.evaluate("1 - 2 * 3 e12"), {0: 1.0, 6: -6.0})
	expect_coefficients(Multivector.evaluate("e1 ^ e2 * 3 + ~(e1 * e2)"), {6: 2.0})
	expect_coefficients(Multivector.evaluate("eo | einf"), {0: -1.0})
	expect_coefficients(Multivector.evaluate("e1 << e12"), {2: 1.0})
	expect_coefficients(Multivector.evaluate("e12 >> e1"), {2: -1.0})
	expect_coefficients(Multivector.evaluate("I & e12"), {6: 1.0})
	expect_coefficients(Multivector.evaluate("!I / 4"), {0: 0.25})
	expect_coefficients(Multivector.evaluate("-pi"), {0: -PI})


func test_functions_are_methods_of_the_class() -> void:
	expect_true(
		Multivector.evaluate("translator(1, 2, 3)").is_equal_approx(
			Multivector.translator(Vector3(1, 2, 3))
		),
		"translator"
	)
	expect_coefficients(Multivector.evaluate("exp(-pi/2 * e12)"), {6: -1.0})
	expect_coefficients(Multivector.evaluate("inverse(2 e12)"), {6: -0.5})


func test_variables() -> void:
	var variables: Dictionary = {
		"v": Vector3(1, 2, 3),
		&"n": 4,
		"x": 0.5,
		"M": Multivector.basis("e45"),
		"unused": 7,
		"größe": 2
	}
	expect_coefficients(
		Multivector.evaluate("v * 2 + n + x * M", variables),
		{0: 4.0, 1: 2.0, 2: 4.0, 3: 6.0, 15: 0.5}
	)
	expect_coefficients(Multivector.evaluate("größe", variables), {0: 2.0})
	expect_equal(variables.size(), 6, "number of variables afterwards")


func test_a_sandwich_in_an_expression() -> void:
	var motor := Multivector.motor_from(Vector3(1, 2, 3), Quaternion(Vector3.UP, 1.0), 1.0)
	var moved := Multivector.evaluate(
		"M * X * ~M", {"M": motor, "X": Multivector.point(Vector3(4, 5, 6))}
	)
	expect_true(
		moved.is_equal_approx(motor.sandwich(Multivector.point(Vector3(4, 5, 6)))),
		"M X ~M is the sandwich product"
	)


func test_interpolation_agrees_with_multivector_lerp() -> void:
	var from := Multivector.motor_from(Vector3(1, 2, 3), Quaternion(Vector3.UP, 1.0), 0.5).scaled(
		-3.0
	)
	var to := Multivector.motor_from(Vector3(-2, 0, 1), Quaternion(Vector3.RIGHT, 2.5), 4.0)
	var motors: Dictionary = {"A": from, "B": to}
	var modes: Dictionary[String, MultivectorLerp.Mode] = {
		"interpolate_linear": MultivectorLerp.LINEAR,
		"interpolate_screw": MultivectorLerp.SCREW,
		"interpolate_separate": MultivectorLerp.SEPARATE,
	}
	for method in modes:
		for t: float in [0.0, 0.3, 0.5, 1.0, 1.5, -1.0]:
			motors["t"] = t
			var value := Multivector.evaluate("%s(A, B, t)" % method, motors)
			var expected := MultivectorLerp.interpolate(from, to, t, modes[method])
			expect_equal(value.coefficients, expected.coefficients, "%s at %s" % [method, t])
	expect_error(
		(
			"Multivector.evaluate: column 22: expected a motor (a product of translators, "
			+ "rotors and dilators) as second argument of interpolate_screw(from, to, t)."
		)
	)
	expect_null(Multivector.evaluate("interpolate_screw(A, e1, 0.5)", motors))


func test_text_survives_a_round_trip() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 11
	for i in 100:
		var numbers := PackedFloat64Array()
		for k in 32:
			numbers.append(
				(
					generator.randfn() * pow(10.0, generator.randi_range(-30, 30))
					if generator.randf() < 0.5
					else 0.0
				)
			)
		var multivector := Multivector.new()
		multivector.coefficients = numbers
		expect_equal(
			Multivector.evaluate(multivector.to_text()).coefficients, numbers, "coefficients"
		)


func test_errors_contain_the_column() -> void:
	for expression: String in INVALID_EXPRESSIONS:
		expect_error("Multivector.evaluate: %s." % INVALID_EXPRESSIONS[expression])
		expect_null(Multivector.evaluate(expression), expression)


func test_invalid_variables() -> void:
	for value: Variant in [null, true, "text", self, Quaternion.IDENTITY]:
		expect_error(
			(
				(
					'Multivector.evaluate: the variable "v" must be a Multivector, a number or a '
					+ "Vector3, not %s."
				)
				% type_string(typeof(value))
			)
		)
		expect_null(Multivector.evaluate("1", {"v": value}))
	for value: Variant in [NAN, Vector3(0, INF, 0)]:
		expect_error("Multivector.evaluate: column 1: 'v' has a coefficient that is not finite.")
		expect_null(Multivector.evaluate("v", {"v": value}))
	expect_error("Multivector.evaluate: variable names must be strings, not int.")
	expect_null(Multivector.evaluate("1", {1: 2}))
	expect_error(
		(
			"Multivector.evaluate: column 1: invalid variable name: 'e1' is a constant; "
			+ "choose another name."
		)
	)
	expect_null(Multivector.evaluate("1", {"e1": 2}))


func test_hostile_expressions_are_errors() -> void:
	var hostile: Dictionary[String, String] = {
		"(".repeat(2000): "column 257: %s" % TOO_DEEP,
		"-".repeat(2000) + "1": "column 257: %s" % TOO_DEEP,
		"exp(".repeat(2000): "column 1028: %s" % TOO_DEEP,
		"1+".repeat(9000) + "1":
		(
			"column 16385: the expression is too long: it has 18001 bytes, and at most 16384 are"
			+ " accepted"
		),
	}
	for expression in hostile:
		expect_error("Multivector.evaluate: %s." % hostile[expression])
		expect_null(Multivector.evaluate(expression))
