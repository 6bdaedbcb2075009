## The base class of the check files: counts the checks and prints those that fail.
class_name Checks
extends RefCounted

var tree: SceneTree
var passed: int = 0
var failed: int = 0


## Checks that type and value are equal; floats within single precision.
func same(value: Variant, expected: Variant) -> void:
	# A null in a variable of an object type has the type of an object.
	var is_null: bool = value == null and expected == null
	if is_null or _is_same(value, expected):
		passed += 1
		return
	failed += 1
	var place: Dictionary = get_stack()[1] if get_stack().size() > 1 else {"source": "?", "line": 0}
	print(
		(
			"FAIL %s:%d: %s (%s) is not %s (%s)"
			% [
				place["source"],
				place["line"],
				var_to_str(value),
				type_string(typeof(value)),
				var_to_str(expected),
				type_string(typeof(expected))
			]
		)
	)


## Announces an error that the next call must print.
func expect_error(message: String) -> void:
	print("[expect] %s" % message)


## The description of a method of SampleValues.
func method_of(method: StringName) -> Dictionary:
	for entry: Dictionary in ClassDB.class_get_method_list("SampleValues", true):
		if entry["name"] == method:
			return entry
	return {}


func _is_same(value: Variant, expected: Variant) -> bool:
	return typeof(value) == typeof(expected) and (value == expected or _close(value, expected))


func _close(value: Variant, expected: Variant) -> bool:
	match typeof(value):
		TYPE_ARRAY:
			var differs := func(i: int) -> bool: return not _is_same(value[i], expected[i])
			return value.size() == expected.size() and not range(value.size()).any(differs)
		TYPE_FLOAT:
			return is_equal_approx(value, expected)
		TYPE_VECTOR3, TYPE_QUATERNION, TYPE_BASIS, TYPE_TRANSFORM3D:
			return value.is_equal_approx(expected)
	return false
