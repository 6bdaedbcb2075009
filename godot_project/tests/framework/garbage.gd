extends RefCounted
## Values of every type for calls with invalid arguments: extremes, NaN, wrong types, freed objects,
## nested containers. The same seed gives the same values. Results of calls are reused as arguments.

const FLOATS: Array[float] = [
	0.0,
	-0.0,
	1.0,
	-1.0,
	0.5,
	2.0,
	PI,
	100.0,
	1e-9,
	1e-320,
	1e9,
	-1e9,
	3.5e38,
	1e300,
	-1e300,
	NAN,
	INF,
	-INF
]
const INTS: Array[int] = [
	0,
	1,
	2,
	3,
	-1,
	5,
	31,
	32,
	255,
	256,
	65536,
	100000,
	16777217,
	2147483647,
	-2147483648,
	4294967295,
	4294967296,
	9223372036854775807,
	-9223372036854775807
]
const STRINGS: Array[String] = [
	"",
	" ",
	"p",
	"q",
	"s",
	"p2",
	"1",
	"-0",
	"p + q",
	"p ^ q",
	"point(1, 2, 3)",
	"sphere(p, 2)",
	"point(1e999, 0, 0)",
	"sqrt(-1)",
	"0 / 0",
	"1 + * 2",
	"((",
	"))",
	"p(",
	"plane(0, 0, 0, 1)",
	"line(p, q)",
	"exp(1000 * e12)",
	"e1 * e2",
	"e12",
	"einf",
	"I",
	"color",
	"visible",
	"ipns",
	"position",
	"radius",
	"#ff0000",
	"#gg",
	"%s %d %n %",
	"\t\n\r",
	"Ω≈ç√",
	"../../root",
	"/root",
	"unique",
	"{}",
	"[]",
	"null",
	'{"entries": 3}',
	'{"coefficients": [1, 2]}',
	'{"format": "ga_godot_scene", "version": 1, "entries": [{"name": "p", "text": 5}]}'
]
## The number of reused results of each type.
const REUSED := 24
const MAX_REUSED_LENGTH := 400

var random := RandomNumberGenerator.new()

var _values: Dictionary[int, Array] = {}
var _reused: Dictionary[int, Array] = {}
var _nodes: Array[Node] = []


## Nodes among the values become children of [param parent], except some that stay outside the tree.
func _init(seed_value: int, parent: Node) -> void:
	random.seed = seed_value
	_values[TYPE_NIL] = [null]
	_values[TYPE_BOOL] = [false, true]
	_values[TYPE_INT] = INTS.duplicate()
	_values[TYPE_FLOAT] = FLOATS.duplicate()
	_values[TYPE_STRING] = _strings()
	_add_vectors()
	_add_transforms()
	_values[TYPE_STRING_NAME] = _values[TYPE_STRING].map(
		func(text: String) -> StringName: return text
	)
	_values[TYPE_NODE_PATH] = _values[TYPE_STRING].map(func(text: String) -> NodePath: return text)
	_values[TYPE_RID] = [RID(), rid_from_int64(1), rid_from_int64(-1)]
	_add_objects(parent)
	_add_containers()


## A value of a type; for objects, one of the class or any other.
func of_type(type: int) -> Variant:
	var reused: Array = _reused.get(type, [])
	if not reused.is_empty() and random.randf() < 0.3:
		return reused[random.randi() % reused.size()]
	var values := _values[type]
	return values[random.randi() % values.size()]


func any() -> Variant:
	return of_type(random.randi() % TYPE_MAX)


## Arguments for a method: mostly of the expected types and number, sometimes of others.
func arguments_of(method: Dictionary) -> Array:
	var result := []
	for argument: Dictionary in method["args"]:
		var type: int = argument["type"]
		result.append(of_type(type) if type != TYPE_NIL and random.randf() < 0.85 else any())
	if random.randf() < 0.05:
		result.resize(random.randi() % 9)
	return result


## Makes a result available as an argument.
func reuse(value: Variant) -> void:
	var type := typeof(value)
	if type == TYPE_NIL or (type == TYPE_STRING and str(value).length() > MAX_REUSED_LENGTH):
		return
	var reused: Array = _reused.get_or_add(type, [])
	if reused.size() < REUSED:
		reused.append(value)
	else:
		reused[random.randi() % REUSED] = value
	if type == TYPE_ARRAY and not (value as Array).is_empty():
		reuse(value[random.randi() % (value as Array).size()])


func add(value: Variant) -> void:
	_values[typeof(value)].append(value)


func free_nodes() -> void:
	for node in _nodes:
		if is_instance_valid(node):
			node.free()


func _strings() -> Array:
	var strings: Array = STRINGS.duplicate()
	for text in STRINGS:
		strings.append(text.substr(0, text.length() / 2) + text.reverse())
	# A lone surrogate, noncharacters, and bytes that are not UTF-8.
	for code: int in [0xd800, 0xffff, 0x10ffff, 0x1]:
		strings.append(String.chr(code))
	strings.append(PackedByteArray([112, 195, 40]).get_string_from_ascii())
	strings.append_array(
		["(".repeat(5000), "p".repeat(20000), "[".repeat(5000), "1+".repeat(2000) + "1"]
	)
	return strings


func _float() -> float:
	return FLOATS[random.randi() % FLOATS.size()]


func _vector3() -> Vector3:
	return Vector3(_float(), _float(), _float())


func _normal3() -> Vector3:
	return Vector3(random.randfn(), random.randfn(), random.randfn())


func _add_vectors() -> void:
	var types: Array[int] = [
		TYPE_VECTOR2,
		TYPE_VECTOR3,
		TYPE_VECTOR4,
		TYPE_QUATERNION,
		TYPE_COLOR,
		TYPE_PLANE,
		TYPE_RECT2,
		TYPE_AABB
	]
	for type in types:
		_values[type] = []
	for i in 24:
		var a := _vector3() if i % 2 == 0 else _normal3()
		var b := _vector3() if i % 3 == 0 else _normal3()
		_values[TYPE_VECTOR2].append(Vector2(a.x, a.y))
		_values[TYPE_VECTOR3].append(a)
		_values[TYPE_VECTOR4].append(Vector4(a.x, a.y, a.z, b.x))
		_values[TYPE_QUATERNION].append(Quaternion(a.x, a.y, a.z, b.x))
		_values[TYPE_QUATERNION].append(Quaternion.from_euler(_normal3()))
		_values[TYPE_COLOR].append(Color(a.x, a.y, a.z, b.x))
		_values[TYPE_PLANE].append(Plane(a, b.x))
		_values[TYPE_RECT2].append(Rect2(a.x, a.y, b.x, b.y))
		_values[TYPE_AABB].append(AABB(a, b))
	_values[TYPE_VECTOR2I] = [Vector2i.ZERO, Vector2i(-2147483648, 2147483647)]
	_values[TYPE_VECTOR3I] = [Vector3i.ZERO, Vector3i(1, -2147483648, 2147483647)]
	_values[TYPE_VECTOR4I] = [Vector4i.ZERO, Vector4i(1, 2, 3, -2147483648)]
	_values[TYPE_RECT2I] = [Rect2i(), Rect2i(1, 2, -3, 2147483647)]


func _add_transforms() -> void:
	var basis: Array = [Basis(), Basis(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO)]
	basis.append_array([Basis.from_scale(Vector3(1, 2, 3)), Basis.from_scale(Vector3(-1, 1, 1))])
	basis.append_array(
		[Basis.from_scale(Vector3.ONE * 1e-30), Basis.from_scale(Vector3.ONE * 1e30)]
	)
	for i in 6:
		basis.append(Basis(_vector3(), _vector3(), _vector3()))
		basis.append(Basis.from_euler(_normal3()))
	_values[TYPE_BASIS] = basis
	_values[TYPE_TRANSFORM3D] = [Transform3D.IDENTITY]
	for entry: Basis in basis:
		_values[TYPE_TRANSFORM3D].append(Transform3D(entry, _vector3()))
		_values[TYPE_TRANSFORM3D].append(Transform3D(entry, _normal3()))
	_values[TYPE_TRANSFORM2D] = [Transform2D.IDENTITY, Transform2D(NAN, Vector2(INF, 1.0))]
	_values[TYPE_PROJECTION] = [Projection.IDENTITY, Projection.ZERO]


func _add_objects(parent: Node) -> void:
	var objects := [
		null, RefCounted.new(), Resource.new(), GAScene.new(), MotorPool.new(), MotorCodec.new()
	]
	for coefficient: float in [0.0, 1.0, 1e-300, 1e200, 1.7e308]:
		var numbers := PackedFloat64Array()
		for i in 32:
			numbers.append(random.randf_range(-1.0, 1.0) * coefficient)
		var multivector := Multivector.new()
		multivector.coefficients = numbers
		objects.append(multivector)
	objects.append(Multivector.point(Vector3(1, 2, 3)))
	objects.append(Multivector.motor(Transform3D(Basis.from_euler(Vector3(1, 2, 3)), Vector3.ONE)))
	for format: int in [MultiMesh.TRANSFORM_2D, MultiMesh.TRANSFORM_3D]:
		for count: int in [0, 3]:
			var multimesh := MultiMesh.new()
			multimesh.transform_format = format as MultiMesh.TransformFormat
			multimesh.use_colors = count == 3
			multimesh.instance_count = count
			objects.append(multimesh)
	for i in 3:
		for node: Node in [
			Node.new(), Node2D.new(), Node3D.new(), Camera3D.new(), MotorSynchronizer.new()
		]:
			node.name = "%s%d" % [node.get_class(), i]
			if i > 0:
				parent.add_child(node)
			objects.append(node)
			_nodes.append(node)
	for node: Node in [Node.new(), Node3D.new()]:
		objects.append(node)
		node.free()
	_values[TYPE_OBJECT] = objects
	var freed: Variant = objects[-1]
	_values[TYPE_CALLABLE] = [Callable(), Callable(parent, &"missing"), func() -> int: return 1]
	_values[TYPE_SIGNAL] = [Signal(), Signal(parent, &"missing"), parent.ready]
	_values[TYPE_ARRAY] = [[], [freed, null, 1.0, [freed]]]


func _add_containers() -> void:
	var transforms: Array[Transform3D] = []
	var nodes: Array[Node3D] = []
	var paths: Array[NodePath] = []
	for i in 5:
		transforms.append(of_type(TYPE_TRANSFORM3D))
		paths.append(of_type(TYPE_NODE_PATH))
		nodes.append(_nodes[(5 * i + 2) % 15] as Node3D)
		_values[TYPE_ARRAY].append_array(
			[transforms.duplicate(), nodes.duplicate(), paths.duplicate()]
		)
	var deep := []
	var nested := {}
	for i in 200:
		deep = [deep, i]
		nested = {i: nested, "p": deep}
	_values[TYPE_ARRAY].append_array([deep, [1, "p", null, Vector3.ONE, deep]])
	_values[TYPE_DICTIONARY] = [
		{}, nested, {"p": 1}, {"q": Multivector.point(Vector3.ONE)}, {1: NAN}
	]
	for i in 8:
		_values[TYPE_DICTIONARY].append(
			{of_type(TYPE_STRING): any_of_scalars(), "value": any_of_scalars()}
		)
	_add_packed()


func any_of_scalars() -> Variant:
	return of_type(
		[TYPE_INT, TYPE_FLOAT, TYPE_STRING, TYPE_VECTOR3, TYPE_OBJECT][random.randi() % 5] as int
	)


func _add_packed() -> void:
	for type in range(TYPE_PACKED_BYTE_ARRAY, TYPE_MAX):
		_values[type] = [type_convert([], type)]
	for size: int in [1, 3, 5, 12, 32, 36, 300]:
		for element: int in [TYPE_INT, TYPE_FLOAT, TYPE_STRING]:
			var values := []
			for i in size:
				values.append(of_type(element))
			if element == TYPE_STRING:
				_values[TYPE_PACKED_STRING_ARRAY].append(PackedStringArray(values))
				continue
			for type: int in [
				TYPE_PACKED_BYTE_ARRAY,
				TYPE_PACKED_INT32_ARRAY,
				TYPE_PACKED_INT64_ARRAY,
				TYPE_PACKED_FLOAT32_ARRAY,
				TYPE_PACKED_FLOAT64_ARRAY
			]:
				_values[type].append(type_convert(values, type))
		for type: int in [
			TYPE_PACKED_VECTOR2_ARRAY,
			TYPE_PACKED_VECTOR3_ARRAY,
			TYPE_PACKED_COLOR_ARRAY,
			TYPE_PACKED_VECTOR4_ARRAY
		]:
			var element: int = {
				TYPE_PACKED_VECTOR2_ARRAY: TYPE_VECTOR2,
				TYPE_PACKED_VECTOR3_ARRAY: TYPE_VECTOR3,
				TYPE_PACKED_COLOR_ARRAY: TYPE_COLOR,
				TYPE_PACKED_VECTOR4_ARRAY: TYPE_VECTOR4
			}[type]
			var values := []
			for i in size:
				values.append(of_type(element))
			_values[type].append(type_convert(values, type))
