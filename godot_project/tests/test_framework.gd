extends "res://tests/framework/test_case.gd"
## The test framework itself: expectations that do not hold must fail.

const CodeSample := preload("res://tests/framework/code_sample.gd")
const TestCase := preload("res://tests/framework/test_case.gd")


func test_true_expectations_pass() -> void:
	var probe := _probe()
	probe.expect_true(true, "truth")
	probe.expect_equal(2, 2)
	probe.expect_near(1.0, 1.05, 0.1)
	probe.expect_vector_near(Vector3.ONE, Vector3.ONE, 0.0)
	probe.expect_transform_near(Transform3D.IDENTITY, Transform3D.IDENTITY, 0.0)
	probe.expect_coefficients(Multivector.basis("e1"), {1: 1.0})
	expect_equal(probe.take_failures().size(), 0, "number of failures")


func test_false_expectations_fail() -> void:
	var probe := _probe()
	probe.expect_true(false, "falsehood")
	probe.expect_equal(2, 3)
	probe.expect_equal(2, 2.0)
	probe.expect_near(1.0, 1.2, 0.1)
	probe.expect_near(NAN, 1.0, 0.1)
	probe.expect_vector_near(Vector3(NAN, 0, 0), Vector3.ZERO, 1.0)
	probe.expect_transform_near(
		Transform3D(Basis.IDENTITY, Vector3(0, NAN, 0)), Transform3D.IDENTITY, 1.0
	)
	probe.expect_coefficients(Multivector.basis("e1"), {2: 1.0})
	probe.expect_coefficients(null, {})
	expect_equal(probe.take_failures().size(), 9, "number of failures")


func test_a_failure_contains_file_line_and_values() -> void:
	var probe := _probe()
	probe.expect_equal(2, 3, "answer")
	var failure := probe.take_failures()[0]
	expect_true(
		failure.begins_with("res://tests/test_framework.gd:"), 'the place in "%s"' % failure
	)
	expect_true(failure.ends_with("answer is 2, expected 3"), 'the values in "%s"' % failure)


func test_a_test_without_expectations_fails() -> void:
	expect_equal(_probe().take_failures(), PackedStringArray(["expects nothing"]))


func test_an_unexpected_error_is_a_fault() -> void:
	# Marks the error as expected in the output, but not in the log.
	print("[expect] unexpected")
	push_error("unexpected")
	var faults := error_log.take_faults()
	expect_equal(faults.size(), 1, "number of faults")
	expect_true(
		faults[0].begins_with("unexpected error: unexpected"), 'the message in "%s"' % faults[0]
	)


func test_an_expected_error_that_is_not_logged_is_a_fault() -> void:
	error_log.expect("never comes")
	expect_equal(
		error_log.take_faults(), PackedStringArray(["expected error was not logged: never comes"])
	)


func test_an_expected_error_is_not_a_fault() -> void:
	expect_error("expected", 2)
	push_error("expected")
	push_error("expected")
	expect_equal(error_log.take_faults().size(), 0)


func test_an_unexpected_warning_is_a_fault() -> void:
	push_warning("unexpected")
	expect_equal(error_log.take_faults().size(), 1, "number of faults")
	expect_warning("expected")
	push_warning("expected")
	expect_equal(error_log.take_faults().size(), 0, "number of faults with an expected warning")


func test_samples_must_print_what_they_state() -> void:
	var sample := 'for i in 2:\n\tassert(i < 2)\nprint(1 + 1, "!") # %s\n'
	expect_equal(CodeSample.count_prints(sample), 1, "number of checked prints")
	expect_equal(CodeSample.find_faults(sample % "2!"), PackedStringArray())
	expect_equal(
		CodeSample.find_faults(sample % "3!"),
		PackedStringArray(['prints 2! instead of print(1 + 1, "!") # 3!'])
	)
	expect_equal(
		CodeSample.find_faults("if false:\n\tprint(1) # 1\n"),
		PackedStringArray(["prints nothing instead of print(1) # 1"])
	)


func test_samples_that_do_not_run_are_faults() -> void:
	expect_error('Parse Error: Identifier "nonsense" not declared in the current scope.')
	expect_equal(
		CodeSample.find_faults("nonsense\n"), PackedStringArray(["does not compile:\nnonsense\n"])
	)


func _probe() -> TestCase:
	var probe := TestCase.new()
	probe.tree = tree
	probe.error_log = error_log
	return probe
