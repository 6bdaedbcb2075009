extends "res://tests/framework/test_case.gd"
## The class reference of Multivector documents each method as registered, each with an example that
## prints what its comment states (test_code_samples.gd runs it).

const ClassReference := preload("res://tests/framework/class_reference.gd")
const CodeSample := preload("res://tests/framework/code_sample.gd")

var _reference := ClassReference.new(&"Multivector")


func test_every_method_is_documented_as_registered() -> void:
	expect_equal(_reference.error, OK, "reading the reference")
	var registered := _reference.registered_methods()
	for method_name in registered:
		expect_equal(
			_reference.methods.get(method_name, ""),
			registered[method_name],
			"signature of %s" % method_name
		)
	for method_name in _reference.methods:
		expect_true(registered.has(method_name), "registration of %s" % method_name)


func test_every_description_has_an_example() -> void:
	expect_true(_reference.descriptions.size() > 60, "number of descriptions")
	for title in _reference.descriptions:
		var samples := _reference.samples_of(title)
		expect_true(samples.size() > 0, "an example of %s" % title)
		for code in samples:
			expect_true(
				CodeSample.count_prints(code) > 0, "a checked print() in the example of %s" % title
			)
