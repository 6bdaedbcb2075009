extends RefCounted
## The base of every test file: each method whose name begins with test_ is one test, run on a fresh
## object. A test may await; it fails if an expectation fails, if an error or a warning nobody
## announced is logged, if an announced one is not, or if it expects nothing at all.

const ErrorLog := preload("res://tests/framework/error_log.gd")

## Set by the runner.
var tree: SceneTree
var error_log: ErrorLog

var _failures := PackedStringArray()
var _expectations := 0
var _nodes: Array[Node] = []


func expect_true(condition: bool, what: String) -> void:
	_expectations += 1
	if not condition:
		fail("does not hold: %s" % what)


## Equal in value and in type: 1 and 1.0 differ.
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


## Every entry of the basis and the origin within the tolerance.
func expect_transform_near(
	actual: Transform3D, expected: Transform3D, tolerance: float, what := "transform"
) -> void:
	_expectations += 1
	var worst := 0.0
	var expected_columns := _columns(expected)
	for difference in _columns(actual):
		difference -= expected_columns.pop_front() as Vector3
		# NaN would vanish in a maximum.
		worst = (
			maxf(worst, difference.abs()[difference.abs().max_axis_index()])
			if difference.is_finite()
			else INF
		)
	if worst > tolerance:
		fail(
			(
				"%s is off by %s, allowed %s\n      actual   %s\n      expected %s"
				% [what, worst, tolerance, actual, expected]
			)
		)


## The coefficients of a multivector, all 32, given those that are not zero by index.
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


## Announces that the next lines log exactly this error. The line that this prints lets whoever reads
## the output tell it from an error that nobody expected.
func expect_error(message: String, times := 1) -> void:
	_expectations += 1
	for i in times:
		print("[expect] %s" % message)
		error_log.expect(message)


## Announces that the next line logs exactly this warning.
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


## The nearest line of the test itself.
func _place() -> String:
	for frame: Dictionary in get_stack():
		var source: String = frame["source"]
		if not source.begins_with("res://tests/framework/"):
			return "%s:%d" % [source, frame["line"]]
	return "somewhere"
