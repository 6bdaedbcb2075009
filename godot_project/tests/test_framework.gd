extends "res://tests/framework/test_case.gd"
## The test framework itself: expectations that do not hold must fail.

const CodeSample := preload("res://tests/framework/code_sample.gd")
const Filter := preload("res://tests/framework/test_filter.gd")
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


func test_a_duration_is_checked_except_in_an_emulator() -> void:
	var slowness := OS.get_environment("GA_GODOT_SLOWNESS")
	OS.unset_environment("GA_GODOT_SLOWNESS")
	var probe := _probe()
	probe.expect_duration_below(1.0, 2.0, "a")
	expect_equal(probe.take_failures().size(), 0, "failures below the limit")
	probe.expect_duration_below(2.0, 2.0, "a")
	probe.expect_duration_below(NAN, 2.0, "a")
	expect_equal(probe.take_failures().size(), 2, "failures above the limit")
	expect_equal(probe.skipped.size(), 0, "skipped")
	OS.set_environment("GA_GODOT_SLOWNESS", "30")
	probe = _probe()
	probe.expect_duration_below(3.0, 2.0, "a")
	expect_equal(probe.take_failures().size(), 0, "failures in an emulator")
	expect_equal(probe.skipped, PackedStringArray(["a takes less than 2.0 ms"]), "skipped")
	OS.unset_environment("GA_GODOT_SLOWNESS")
	if not slowness.is_empty():
		OS.set_environment("GA_GODOT_SLOWNESS", slowness)


func test_the_argument_selects_tests() -> void:
	for row: Array in [
		# The argument, whether it selects test_b of test_a.gd, and whether this file is loaded for it.
		["", true, true],
		["a.gd", true, true],
		["t_b", true, true],
		["test_a test_b", true, true],
		["test_a test_c", false, true],
		["other", false, true],
		["test_c.gd", false, false],
		["test_c.gd,test_a.gd", true, true],
		["test_c.gd,t_b", true, true],
		["test_c.gd,test_d.gd", false, false],
	]:
		var argument: String = row[0]
		expect_equal(Filter.selects(argument, "test_a.gd", "test_b"), row[1], "by " + argument)
		expect_equal(Filter.may_select_from(argument, "test_a.gd"), row[2], "for " + argument)


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
