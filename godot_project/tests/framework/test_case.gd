extends RefCounted
## The base class of all test files. Each method whose name begins with test_ is a test and runs on
## a new object; it may await. A test fails if an expectation fails, if it has no expectation, if an
## unexpected error or warning is logged, or if an expected one is not.

const Emulation := preload("res://tests/framework/emulation.gd")
const ErrorLog := preload("res://tests/framework/error_log.gd")

## Set by the runner.
var tree: SceneTree
var error_log: ErrorLog

## Expectations that an emulated engine cannot meet.
var skipped := PackedStringArray()

var _failures := PackedStringArray()
var _expectations := 0
var _nodes: Array[Node] = []


func expect_true(condition: bool, what: String) -> void:
	_expectations += 1
	if not condition:
		fail("does not hold: %s" % what)


## Compares value and type: 1 and 1.0 differ.
func expect_equal(actual: Variant, expected: Variant, what := "value") -> void:
	_expectations += 1
	if typeof(actual) != typeof(expected) or actual != expected:
		fail("%s is %s, expected %s" % [what, var_to_str(actual), var_to_str(expected)])


func expect_null(actual: Object, what := "value") -> void:
	_expectations += 1
	if actual != null:
		fail("%s is %s, expected null" % [what, actual])


func expect_near(actual: float, expected: float, tolerance: float, what := "value") -> void:
	_expectations += 1
	# Written so that NaN fails.
	if not absf(actual - expected) <= tolerance:
		fail("%s is %s, expected %s within %s" % [what, actual, expected, tolerance])


func expect_vector_near(
	actual: Vector3, expected: Vector3, tolerance: float, what := "vector"
) -> void:
	_expectations += 1
	if not actual.distance_to(expected) <= tolerance:
		fail("%s is %s, expected %s within %s" % [what, actual, expected, tolerance])


## Each component of the basis and the origin must be within the tolerance.
func expect_transform_near(
	actual: Transform3D, expected: Transform3D, tolerance: float, what := "transform"
) -> void:
	_expectations += 1
	var worst := 0.0
	var expected_columns := _columns(expected)
	for difference in _columns(actual):
		difference -= expected_columns.pop_front() as Vector3
		# maxf() would drop NaN.
		worst = (
			maxf(worst, difference.abs()[difference.abs().max_axis_index()])
			if difference.is_finite()
			else INF
		)
	if worst > tolerance:
		fail(
			(
				"%s deviates by %s, more than %s\n      actual   %s\n      expected %s"
				% [what, worst, tolerance, actual, expected]
			)
		)


## Compares all 32 coefficients. [param nonzero] has the expected ones by index; the rest is zero.
func expect_coefficients(
	actual: Multivector, nonzero: Dictionary[int, float], tolerance := 1e-12, what := "multivector"
) -> void:
	_expectations += 1
	if actual == null:
		fail("%s is null" % what)
		return
	var numbers := actual.coefficients
	for i in 32:
		var expected: float = nonzero.get(i, 0.0)
		if not absf(numbers[i] - expected) <= tolerance:
			fail("%s: coefficient %d is %s, expected %s" % [what, i, numbers[i], expected])
			return


## Expects that something took less than [param limit] milliseconds. An emulated engine skips this.
func expect_duration_below(milliseconds: float, limit: float, what: String) -> void:
	_expectations += 1
	if Emulation.is_active():
		skipped.append("%s takes less than %s ms" % [what, limit])
	elif not milliseconds < limit:
		fail("%s takes %s ms, expected less than %s ms" % [what, milliseconds, limit])


## Expects the code that follows to log exactly this error. The printed line marks the error as
## expected in the output.
func expect_error(message: String, times := 1) -> void:
	_expectations += 1
	for i in times:
		print("[expect] %s" % message)
		error_log.expect(message)


## Expects the code that follows to log this warning; see [method ErrorLog.expect].
func expect_warning(message: String) -> void:
	_expectations += 1
	error_log.expect(ErrorLog.WARNING + message)


func fail(reason: String) -> void:
	_failures.append("%s: %s" % [_place(), reason])


## Adds a node to the tree; it is freed after the test.
func add_node(node: Node) -> void:
	_nodes.append(node)
	tree.root.add_child(node)


func wait_frames(count: int) -> void:
	for i in count:
		await tree.process_frame


func take_failures() -> PackedStringArray:
	if _expectations == 0:
		_failures.append("expects nothing")
	return _failures


func free_nodes() -> void:
	for node in _nodes:
		if is_instance_valid(node):
			node.free()
	_nodes.clear()


func _columns(transform: Transform3D) -> Array[Vector3]:
	return [transform.basis.x, transform.basis.y, transform.basis.z, transform.origin]


## The innermost line on the stack outside the framework.
func _place() -> String:
	for frame: Dictionary in get_stack():
		var source: String = frame["source"]
		if not source.begins_with("res://tests/framework/"):
			return "%s:%d" % [source, frame["line"]]
	return "somewhere"
