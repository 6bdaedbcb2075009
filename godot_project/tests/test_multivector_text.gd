extends "res://tests/framework/test_case.gd"
## Multivector as text: sums in both bases, LaTeX, and the JSON of ganja.js, in both directions.

const ZEROS := "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0"

const INVALID_JSON: Dictionary[String, String] = {
	"": "column 1: expected '[' or '{', found the end",
	"[1]": "column 3: expected 32 numbers, found the end of the array after 1",
	"[NaN,%s]" % ZEROS: "column 2: expected a number, found 'N'",
	"[1e999,%s]" % ZEROS: "column 2: the number is too large; at most 1.8e308 is accepted",
	"[0,0,%s]" % ZEROS: "column 65: expected ']' after 32 numbers, found ','",
	"[0,%s] x" % ZEROS: "column 67: expected the end, found 'x'",
	'{"coefficients": 3}': "column 18: expected '[', found '3'",
	'[0,\n"é"]': "line 2, column 1: expected a number, found '\"'",
}


func test_to_text() -> void:
	expect_equal(Multivector.new().to_text(), "0")
	expect_equal(Multivector.scalar(-2.5).to_text(), "-2.5")
	var sum := Multivector.scalar(1.0).add(Multivector.basis("e12").scaled(2.0)).subtract(
		Multivector.basis("e4").scaled(0.5)
	)
	expect_equal(sum.to_text(), "1 - 0.5 e4 + 2 e12")
	expect_equal(Multivector.basis("I").scaled(-1.0).to_text(), "-e12345")


func test_to_text_in_the_null_basis() -> void:
	expect_equal(
		Multivector.point(Vector3(1, 2, 3)).to_text(true), "e1 + 2 e2 + 3 e3 + 7 einf + eo"
	)
	expect_equal(
		Multivector.point(Vector3(1, 2, 3)).to_text(false), "e1 + 2 e2 + 3 e3 + 6.5 e4 + 7.5 e5"
	)


func test_to_latex() -> void:
	var sum := Multivector.scalar(1.0).subtract(Multivector.basis("e12").scaled(2.0))
	expect_equal(sum.to_latex(), "1 - 2 \\mathbf{e}_{12}")


func test_to_json() -> void:
	expect_equal(Multivector.scalar(0.1).to_json(), "[0.1,%s]" % ZEROS)
	var numbers: Array = JSON.parse_string(_random().to_json())
	expect_equal(numbers.size(), 32)


func test_json_survives_a_round_trip_bit_for_bit() -> void:
	var generator := RandomNumberGenerator.new()
	generator.seed = 3
	for i in 200:
		var numbers := PackedFloat64Array()
		for k in 32:
			numbers.append(generator.randfn() * pow(10.0, generator.randi_range(-300, 300)))
		var multivector := Multivector.new()
		multivector.coefficients = numbers
		expect_equal(Multivector.from_json(multivector.to_json()).coefficients, numbers)


func test_from_json_reads_the_output_of_ganja() -> void:
	# JSON.stringify of a typed array, and a wrapped array.
	var keys := PackedStringArray()
	for i in 32:
		keys.append('"%d":%d' % [i, 5 if i == 6 else 0])
	expect_coefficients(Multivector.from_json("{%s}" % ",".join(keys)), {6: 5.0})
	expect_coefficients(Multivector.from_json('{"coefficients": [2, %s]}' % ZEROS), {0: 2.0})
	expect_coefficients(Multivector.from_json("  [ -1e-3 ,\n%s]\n" % ZEROS), {0: -0.001})


func test_errors_of_from_json_contain_the_position() -> void:
	for text: String in INVALID_JSON:
		expect_error("Multivector.from_json: %s." % INVALID_JSON[text])
		expect_null(Multivector.from_json(text), text)


func _random() -> Multivector:
	var numbers := PackedFloat64Array()
	for k in 32:
		numbers.append(sin(k * 1.7))
	var multivector := Multivector.new()
	multivector.coefficients = numbers
	return multivector
