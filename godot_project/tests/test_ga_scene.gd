extends "res://tests/framework/test_case.gd"
## GAScene: entries, their dependencies, and signals.

var _scene := GAScene.new()
var _changes: Array[PackedStringArray] = []


func _init() -> void:
	_scene.entries_changed.connect(_on_entries_changed)


func test_entries_follow_each_other() -> void:
	expect_equal(_scene.add_entry("a", "point(1, 2, 3)"), OK, "adding a")
	expect_equal(_scene.add_entry("l", "a ^ b ^ einf"), OK, "adding l")
	expect_equal(_scene.get_error("l"), "column 5: there is no entry 'b'", "error of l")
	expect_null(_scene.get_value("l"))
	expect_equal(_scene.add_entry("b", "point(1, 2, 5)"), OK, "adding b")
	expect_equal(_scene.get_error("l"), "", "error of l")
	expect_equal(_scene.get_value("l").classify().kind, "line", "kind of l")
	expect_equal(_scene.get_names(), PackedStringArray(["a", "l", "b"]), "names")
	expect_equal(_scene.set_expression("b", "point(1, 4, 3)"), OK, "setting b")
	expect_vector_near(_scene.get_value("l").classify().direction as Vector3, Vector3.UP, 1e-6)
	expect_equal(
		_changes,
		(
			[
				PackedStringArray(["a"]),
				PackedStringArray(["l"]),
				PackedStringArray(["b", "l"]),
				PackedStringArray(["b", "l"])
			]
			as Array[PackedStringArray]
		),
		"changes"
	)


func test_a_change_that_changes_nothing_is_silent() -> void:
	_scene.add_entry("a", "1")
	_scene.add_entry("b", "a + 1")
	_changes.clear()
	_scene.set_expression("a", "2 - 1")
	_scene.move_entry("b", 0)
	_scene.set_entry_attribute("a", "visible", false)
	expect_equal(_changes.size(), 0, "number of signals")
	expect_equal(_scene.get_names(), PackedStringArray(["b", "a"]), "names")


func test_errors_stay_local() -> void:
	_scene.add_entry("a", "1 +")
	_scene.add_entry("b", "2 a")
	_scene.add_entry("c", "b + 1")
	_scene.add_entry("d", "3")
	expect_equal(
		_scene.get_error("a"),
		"column 4: expected a number, a name or '(', found the end",
		"error of a"
	)
	expect_equal(_scene.get_error("b"), "column 3: 'a' has an error", "error of b")
	expect_equal(_scene.get_error("c"), "column 1: 'b' has an error, caused by 'a'", "error of c")
	expect_equal(_scene.get_value("d").coefficients[0], 3.0, "d")
	_scene.set_expression("a", "c")
	expect_equal(
		_scene.get_error("a"), "column 1: circular dependency a -> c -> b -> a", "error of a"
	)
	_scene.set_expression("a", "1")
	expect_equal(_scene.get_value("c").coefficients[0], 3.0, "c")


func test_an_expression_is_described_without_adding_it() -> void:
	_scene.add_entry("a", "2")
	_scene.add_entry("s", "!sphere(e1, a)")
	_scene.add_entry("p", "e3 ^ einf")
	_scene.set_entry_attribute("p", "ipns", true)
	var before := _scene.document
	_changes.clear()
	var found := _scene.describe_expression("point(a, 0, 0)")
	var value: Multivector = found["value"]
	expect_equal(value.coefficients, Multivector.point(Vector3(2, 0, 0)).coefficients, "value")
	expect_equal(found["description"], "point, at (2, 0, 0)", "description")
	expect_equal(found["error"], "", "error")
	expect_equal(
		_scene.describe_expression("a + s +"),
		{
			"value": null,
			"description": "",
			"error": "column 8: expected a number, a name or '(', found the end"
		},
		"an expression with an error"
	)
	expect_equal(
		_scene.describe_expression("e3 ^ einf", "p")["description"],
		"dual direction, normal (0, 0, -1)",
		"description as p"
	)
	expect_equal(
		_scene.describe_expression("norm(s)", "a")["error"],
		"column 6: circular dependency a -> s -> a",
		"error as a"
	)
	expect_equal(
		_scene.describe_expression("b", &"b")["error"],
		"column 1: 'b' refers to itself",
		"error as a new entry"
	)
	expect_equal(_scene.document, before, "document")
	expect_equal(_changes.size(), 0, "number of signals")


func test_renaming_and_removing() -> void:
	_scene.add_entry("a", "1")
	_scene.add_entry("b", "a + a*2")
	expect_equal(_scene.rename_entry("a", "x"), OK, "renaming")
	expect_equal(_scene.get_expression("b"), "x + x*2", "expression of b")
	expect_equal(_scene.get_dependents("x"), PackedStringArray(["b"]), "dependents")
	expect_equal(_changes.back(), PackedStringArray(["a", "x"]), "changes")
	expect_equal(_scene.remove_entry("x"), OK, "removing")
	expect_equal(_scene.get_error("b"), "column 1: there is no entry 'x'", "error of b")
	expect_equal(_changes.back(), PackedStringArray(["x", "b"]), "changes")


func test_invalid_calls_are_refused() -> void:
	_scene.add_entry("a", "1")
	_changes.clear()
	expect_error("GAScene.add_entry: an entry 'a' already exists.")
	expect_equal(_scene.add_entry("a", "2"), ERR_INVALID_PARAMETER, "adding again")
	expect_error("GAScene.add_entry: 'e12' is a constant; choose another name.")
	expect_equal(_scene.add_entry("e12", "2"), ERR_INVALID_PARAMETER, "adding e12")
	expect_error("GAScene.remove_entry: there is no entry 'b'.")
	expect_equal(_scene.remove_entry("b"), ERR_INVALID_PARAMETER, "removing b")
	expect_error('GAScene.get_value: there is no entry "b"; get_names() lists the entries.')
	expect_null(_scene.get_value("b"))
	expect_equal(_scene.get_names(), PackedStringArray(["a"]), "names")
	expect_equal(_changes.size(), 0, "number of signals")


func _on_entries_changed(names: PackedStringArray) -> void:
	_changes.append(names)
