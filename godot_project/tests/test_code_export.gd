extends "res://tests/framework/test_case.gd"
## Entries exported as code.

const CodeExport := preload("res://addons/ga_godot/playground/document/code_export.gd")


func test_dependencies_come_first_and_once() -> void:
	var scene := _scene(
		["d", "c + b", "c", "b + a", "b", "a + 1", "a", "2", "bad", "nowhere", "worse", "bad + a"]
	)
	expect_equal(_exported(scene, ["d"]), PackedStringArray(["a", "b", "c", "d"]), "the order")
	expect_equal(
		_exported(scene, ["a", "d", "c", "worse"]), PackedStringArray(["a", "b", "c", "d"]), "order"
	)


func test_long_chains() -> void:
	var texts := ["a0", "1"]
	for i in range(1, 3000):
		texts.append_array(["a%d" % i, "a%d" % (i - 1)])
	var names := _exported(_scene(texts), ["a2999"])
	expect_equal(names.size(), 3000, "exported entries")
	expect_equal(names[0], "a0", "the first entry")
	expect_equal(names[-1], "a2999", "the last entry")


## Eight times the entries take less than 24 times as long.
func test_time_is_proportional_to_the_number_of_entries() -> void:
	var times: Array[float] = []
	for count: int in [4000, 32000]:
		var lines := PackedStringArray()
		for i in count:
			lines.append('{"name": "a%d", "expression": "1"}' % i)
		var scene := GAScene.new()
		expect_equal(scene.load_json('{"entries": [%s]}' % ",".join(lines)), OK, "loading")
		var best := INF
		for attempt in 3:
			var begin := Time.get_ticks_usec()
			CodeExport.gdscript(scene, scene.get_names())
			best = minf(best, Time.get_ticks_usec() - begin)
		times.append(best)
	var ratio := times[1] / times[0]
	expect_true(ratio < 24.0, "the ratio of the times, %.1f, is less than 24" % ratio)


func _scene(names_and_expressions: Array) -> GAScene:
	var scene := GAScene.new()
	var lines := PackedStringArray()
	for i in range(0, names_and_expressions.size(), 2):
		lines.append(
			(
				'{"name": "%s", "expression": "%s"}'
				% [names_and_expressions[i], names_and_expressions[i + 1]]
			)
		)
	expect_equal(scene.load_json('{"entries": [%s]}' % ",".join(lines)), OK, "loading")
	return scene


## The names of the variables, in order.
func _exported(scene: GAScene, entries: PackedStringArray) -> PackedStringArray:
	var names := PackedStringArray()
	for line in CodeExport.gdscript(scene, entries).split("\n", false):
		names.append(line.get_slice(" ", 1))
	return names
