## Values of every type in both directions: by typed calls, and as Variants through call().
extends Checks

var values: SampleValues = SampleValues.new()


func both(method: StringName, arguments: Array, expected: Variant) -> void:
	same(values.callv(method, arguments), expected)


func check_numbers() -> void:
	same(values.negate(true), false)
	same(values.negate(false), true)
	same(values.add_up(-100, 60000, -2000000000, 9000000000), 7000059900)
	same(values.halve(3.0), 1.5)
	both(&"negate", [true], false)
	both(&"add_up", [-100, 60000, -2000000000, 9000000000], 7000059900)
	both(&"halve", [3.0], 1.5)
	both(&"halve", [3], 1.5)


func check_texts() -> void:
	same(values.repeat("ab", 3, "/"), "ab/ab/ab")
	same(values.repeat("äß→😀", 2, ""), "äß→😀äß→😀")
	same(values.repeat("", 0, ""), "")
	same(values.count_bytes("äß→😀"), 11)
	same(values.count_bytes(""), 0)
	same(values.prefixed(&"name"), &"pre_name")
	same(values.child_path(^"a/b"), ^"a/b/child")
	both(&"repeat", ["ab", 3, "/"], "ab/ab/ab")
	both(&"prefixed", ["name"], &"pre_name")
	both(&"child_path", ["a"], ^"a/child")


func check_geometry() -> void:
	var turn := Quaternion(Vector3(1, 2, 2) / 3.0, 1.1)
	var basis := Basis(turn).scaled(Vector3(2, 3, 4))
	var placed := Transform3D(basis, Vector3(7, 8, 9))
	var other := Transform3D(Basis(turn), Vector3(1, 0, 0))
	same(values.sum(Vector2(1, 2), Vector2(3, 8)), Vector2(4, 10))
	# 2 (a - b) + b (a . b) is (-13, 41.5, 9.75).
	same(values.combine(Vector3(1, 2, 3), Vector3(-2, 5, 0.5)), Vector3(41.5, -13, 9.75))
	same(values.conjugate(turn), turn.inverse())
	var reversed := Basis(basis.z, basis.y, basis.x)
	same(
		values.inspect(basis, turn.get_axis()),
		[basis.z, basis * turn.get_axis(), basis * basis, reversed]
	)
	same(values.chain(placed, other), [placed * other, other * placed.origin])
	both(&"sum", [Vector2(1, 2), Vector2(3, 8)], Vector2(4, 10))
	both(&"combine", [Vector3(1, 0, 0), Vector3(0, 1, 0)], Vector3(-2, 2, 0))
	both(&"conjugate", [turn], turn.inverse())
	both(&"chain", [other, other], [other * other, other * other.origin])


func check_plain_data() -> void:
	same(
		values.moved_box(AABB(Vector3(1, 2, 3), Vector3(4, 5, 6)), Vector3(1, 1, 1)),
		AABB(Vector3(2, 3, 4), Vector3(4, 5, 6))
	)
	same(values.without_red(Color(0.25, 0.5, 0.75, 0.125)), Color(0, 0.5, 0.75, 0.125))
	same(values.make_rid(), true)
	both(&"without_red", [Color(1, 1, 1)], Color(0, 1, 1))


func check_equality() -> void:
	var first: Array = [Vector2(1, 2), Color.RED, Transform3D(Basis.IDENTITY, Vector3.UP)]
	var second: Array = [Vector2(1, 3), Color.BLUE, Transform3D.IDENTITY]
	for different: int in [-1, 0, 1, 2]:
		var arguments: Array = []
		for i: int in 3:
			arguments.append_array([first[i], second[i] if i == different else first[i]])
		both(&"equal", arguments, different == -1)


func check_variants() -> void:
	for value: Variant in [
		null,
		true,
		-5,
		2.5,
		"text",
		&"name",
		^"path",
		Vector3(1, 2, 3),
		Transform3D.IDENTITY,
		[1, "two"],
		{"a": 1},
		PackedByteArray([1, 2]),
		values,
		Color.RED,
		Vector2i(3, 4)
	]:
		same(values.echo(value), value)
		same(values.type_of(value), type_string(typeof(value)) if value != null else "Nil")
		both(&"echo", [value], value)
	same(values.echo(), null)


func check_containers() -> void:
	same(values.summarize([1, 2.5, 3]), {"sum": 6.5, "reversed": [3, 2.5, 1], "first": 1})
	same(values.summarize(), {"sum": 0.0, "reversed": [], "first": null})
	same(values.keys_and_values({"a": 1, 2: [3]}), ["a", 1, 2, [3]])
	same(values.keys_and_values({}), [])


func check_packed_arrays() -> void:
	var bytes := PackedByteArray([0, 1, 255])
	same(values.bytes(bytes), PackedByteArray([255, 254, 0]))
	same(bytes, PackedByteArray([0, 1, 255]))
	same(values.bytes(PackedByteArray()), PackedByteArray())
	same(values.ints(PackedInt32Array([1, -2])), PackedInt32Array([7, 1, -2]))
	var vectors := PackedVector3Array([Vector3(1, 2, 3), Vector3(4, 5, 6)])
	same(values.vectors(vectors), vectors + PackedVector3Array([Vector3(5, 7, 9)]))
	same(values.floats(PackedFloat32Array([0.5, -3])), PackedFloat32Array([1, -6]))
	same(values.floats(PackedFloat32Array()), PackedFloat32Array())
	var squares: PackedInt32Array = values.squares(1000)
	same(squares.size(), 1000)
	same(range(1000).all(func(i: int) -> bool: return squares[i] == i * i), true)
	same(values.doubles(PackedFloat64Array([0.1])), PackedFloat64Array([1.1]))
	same(values.strings(PackedStringArray(["a", "ö"])), PackedStringArray(["A", "Ö!"]))
	both(&"floats", [[1, 2]], PackedFloat32Array([2, 4]))


func check_typed_arrays() -> void:
	var transforms: Array[Transform3D] = [
		Transform3D.IDENTITY, Transform3D(Basis.IDENTITY, Vector3(1, 2, 3))
	]
	var moved: Array[Transform3D] = values.move_all(transforms, Vector3(0, 0, 10))
	same(moved.size(), 2)
	same(moved[1].origin, Vector3(1, 2, 13))
	same(transforms[1].origin, Vector3(1, 2, 3))
	same(moved.is_typed(), true)
	same(moved.get_typed_builtin(), TYPE_TRANSFORM3D)
	# An untyped array with elements of the right type is accepted, too.
	moved = values.call("move_all", [Transform3D.IDENTITY], Vector3.UP)
	same(moved[0].origin, Vector3.UP)
	var untyped: Array = [Transform3D.IDENTITY]
	same(values.move_all(untyped, Vector3.UP)[0].origin, Vector3.UP)
	var wrong: Array = ["text"]
	expect_error('Unable to convert array index 0 from "String" to "Transform3D".')
	same(values.move_all(wrong, Vector3.UP).size(), 0)
	same(values.move_all([], Vector3.UP).get_typed_builtin(), TYPE_TRANSFORM3D)


func check_conversions_free_what_they_make() -> void:
	var arguments: Array = [
		[1, 2, 3], {"a": 1}, "text", PackedFloat32Array([1, 2]), [] as Array[Transform3D]
	]
	same(values.convert_often(arguments, 10), 100)
	var before: int = OS.get_static_memory_usage()
	same(values.convert_often(arguments, 20000), 200000)
	same(OS.get_static_memory_usage() - before < 100000, true)
