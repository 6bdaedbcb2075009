extends "res://tests/framework/network_test.gd"
## Calls every method, property and signal of each class with invalid arguments of every type, in
## and outside the tree. Nothing may crash, hang or leak, and the objects must stay usable. The
## errors of these calls are expected, and not printed.

const Garbage := preload("res://tests/framework/garbage.gd")

const CALLS := 20000
const SEED := 20261130
const CALLS_PER_FRAME := 400
## After so many frames, the two objects are replaced by new ones.
const FRAMES_PER_OBJECT := 10
## Notifications that the engine allows scripts to send to a node in the tree.
const SAFE_NOTIFICATIONS: Array[int] = [
	Node.NOTIFICATION_READY,
	Node.NOTIFICATION_PROCESS,
	Node.NOTIFICATION_PHYSICS_PROCESS,
	Node.NOTIFICATION_INTERNAL_PROCESS,
	Node.NOTIFICATION_INTERNAL_PHYSICS_PROCESS,
	Node3D.NOTIFICATION_VISIBILITY_CHANGED,
	Node3D.NOTIFICATION_TRANSFORM_CHANGED,
]
const ALL_NOTIFICATIONS: Array[int] = [
	Node.NOTIFICATION_ENTER_TREE,
	Node.NOTIFICATION_EXIT_TREE,
	Node.NOTIFICATION_READY,
	Node.NOTIFICATION_PAUSED,
	Node.NOTIFICATION_PROCESS,
	Node.NOTIFICATION_PHYSICS_PROCESS,
	Node.NOTIFICATION_INTERNAL_PROCESS,
	Node.NOTIFICATION_INTERNAL_PHYSICS_PROCESS,
	Node3D.NOTIFICATION_ENTER_WORLD,
	Node3D.NOTIFICATION_EXIT_WORLD,
	Node3D.NOTIFICATION_VISIBILITY_CHANGED,
	Node3D.NOTIFICATION_TRANSFORM_CHANGED,
]
## Called by the inspector.
const INSPECTOR_METHOD := "_get_linked_undo_properties"
## Set this environment variable to print each call before it is made.
const TRACE := "GA_GODOT_TRACE_CALLS"

var _calls := 0
var _objects: Array[Object] = []
var _methods: Array[Dictionary] = []
var _members: Array[Dictionary] = []
var _signals: Array[Dictionary] = []
var _garbage: Garbage
var _trace := OS.has_environment(TRACE)


## Callbacks of the engine are not methods that scripts can call by name.
func test_no_callback_is_bound() -> void:
	for type in ClassDB.get_class_list():
		if ClassDB.class_get_api_type(type) == ClassDB.API_EXTENSION:
			for method in ClassDB.class_get_method_list(type, true):
				var title: String = method["name"]
				var is_public := not title.begins_with("_") or title == INSPECTOR_METHOD
				expect_true(is_public, "%s.%s is public" % [type, title])


## A script can send any notification to a node that has not entered the tree.
func test_notifications_outside_the_tree() -> void:
	Engine.print_error_messages = false
	for type: StringName in [&"GANode3D", &"MultivectorLerp", &"MotorSynchronizer"]:
		for first in ALL_NOTIFICATIONS:
			for second in ALL_NOTIFICATIONS:
				var node: Node = ClassDB.instantiate(type)
				if node is GANode3D:
					node.set(&"multivector", Multivector.point(Vector3.ONE))
				node.notification(first)
				node.notification(second)
				expect_true(not node.is_inside_tree(), "%s is outside of the tree" % type)
				node.free()


func test_calls_of_multivector() -> void:
	await _sweep(&"Multivector", _check_multivector)


func _check_multivector(point: Multivector) -> void:
	point.coefficients = Multivector.point(Vector3(1, 2, 3)).coefficients
	var moved := Multivector.translator(Vector3(1, 0, 0)).sandwich(point)
	expect_vector_near(moved.classify()["center"] as Vector3, Vector3(2, 2, 3), 1e-6, "point")


func test_calls_of_ga_scene() -> void:
	await _sweep(&"GAScene", _check_ga_scene)


func _check_ga_scene(scene: GAScene) -> void:
	expect_equal(scene.load_json('{"entries": []}'), OK, "load_json")
	expect_equal(scene.add_entry("p", "point(1, 2, 3)"), OK, "add_entry")
	expect_equal(scene.add_entry("s", "sphere(p, 2)"), OK, "add_entry")
	expect_near(scene.get_value("s").classify()["radius"] as float, 2.0, 1e-9, "radius")
	expect_equal(scene.get_dependents("p"), PackedStringArray(["s"]), "dependents")


func test_calls_of_ga_node_3d() -> void:
	await _sweep(&"GANode3D", _check_ga_node_3d)


func _check_ga_node_3d(node: GANode3D) -> void:
	node.scene = null
	node.multivector = Multivector.point(Vector3(1, 2, 3))
	node.transform = Transform3D.IDENTITY
	node.visibility_parent = NodePath()
	node.update_drawing()
	expect_equal(node.get_value(), node.multivector, "value")
	expect_true("point" in node.describe().to_lower(), "describe() is %s" % node.describe())


func test_calls_of_multivector_lerp() -> void:
	await _sweep(&"MultivectorLerp", _check_multivector_lerp)


func _check_multivector_lerp(mover: MultivectorLerp) -> void:
	mover.start_motor = Multivector.translator(Vector3(0, 0, 0))
	mover.end_motor = Multivector.translator(Vector3(4, 0, 0))
	mover.local = false
	mover.mode = MultivectorLerp.LINEAR
	if mover.is_inside_tree():
		var target := Node3D.new()
		mover.add_child(target)
		mover.target = target.get_path()
		mover.factor = 0.25
		expect_vector_near(target.global_position, Vector3(1, 0, 0), 1e-6, "target")
	expect_equal(mover.end_motor.get_translation(), Vector3(4, 0, 0), "end_motor")


func test_calls_of_motor_pool() -> void:
	await _sweep(&"MotorPool", _check_motor_pool)


func _check_motor_pool(pool: MotorPool) -> void:
	pool.clear()
	var index := pool.acquire()
	pool.set_from(index, Transform3D.IDENTITY)
	pool.set_to(index, Transform3D(Basis(), Vector3(2, 0, 0)))
	pool.interpolate(0.5, MultivectorLerp.LINEAR)
	expect_vector_near(pool.get_transform(index).origin, Vector3(1, 0, 0), 1e-6, "pose")
	expect_equal(pool.get_count(), 1, "count")


func test_calls_of_motor_codec() -> void:
	await _sweep(&"MotorCodec", _check_motor_codec)


func _check_motor_codec(codec: MotorCodec) -> void:
	codec.position_tolerance = 0.001
	codec.rotation_tolerance = 0.1
	var transforms: Array[Transform3D] = [Transform3D(Basis(), Vector3(1, 2, 3))]
	var decoded := codec.decode(codec.encode(PackedInt32Array([7]), transforms))
	expect_equal(decoded["ids"], PackedInt32Array([7]), "ids")
	var shown: Transform3D = decoded["transforms"][0]
	expect_vector_near(shown.origin, Vector3(1, 2, 3), 0.001, "pose")


func test_calls_of_motor_sender() -> void:
	await _sweep(&"MotorSender", _check_motor_sender)


func _check_motor_sender(sender: MotorSender) -> void:
	var id := 1234567
	expect_true(sender.add_body(id, Transform3D.IDENTITY), "the body is added")
	expect_true(sender.has_body(id), "the body exists")
	expect_true(sender.remove_body(id), "the body is removed")


func test_calls_of_motor_receiver() -> void:
	await _sweep(&"MotorReceiver", _check_motor_receiver)


func _check_motor_receiver(receiver: MotorReceiver) -> void:
	receiver.clear()
	receiver.min_delay = 0.0
	receiver.max_bodies = 100
	var sender := MotorSender.new()
	sender.add_body(3, Transform3D(Basis(), Vector3(1, 2, 3)))
	sender.add_receiver(0, 0.0)
	for tick in 120:
		var now := tick / 60.0
		sender.observe(3, now, Transform3D(Basis(), Vector3(1, 2, 3)))
		for packet in sender.flush(now):
			expect_equal(receiver.accept(packet["bytes"] as PackedByteArray, now), "", "accept")
		receiver.advance(now)
		sender.accept(0, receiver.take_ack(now), now)
	expect_true(receiver.has_body(3), "the body is received")
	expect_vector_near(receiver.get_transform(3).origin, Vector3(1, 2, 3), 0.01, "pose")


## Two connected peers: the server's synchronizer gets the calls, too, and then replicates a new
## body.
func test_calls_of_motor_synchronizer() -> void:
	# Not over ENet, which drops unreliable packets for seconds after slow frames.
	await connect_peers(1, 3, true)
	await move(branches[0], SETTLE)
	var synchronizer := branches[0].synchronizer
	await _sweep(&"MotorSynchronizer", func(_object: Object) -> void: pass, [synchronizer])
	for property in ClassDB.class_get_property_list(&"MotorSynchronizer", true):
		var title: String = property["name"]
		synchronizer.set(title, branches[1].synchronizer.get(title))
	for branch in branches:
		branch.add_body("New4")
	await move(branches[0], SETTLE)
	var body: Node3D = branches[1].world.get_node(^"New4")
	var bound := 1.2 * synchronizer.position_tolerance + 0.001
	for tick in MORE_TICKS:
		if distance_from_path(body) > bound:
			await move(branches[0], 1.0 / Engine.physics_ticks_per_second)
	expect_true(distance_from_path(body) <= bound, "the new body follows its path")
	expect_true(body.position.length() > 5.0, "the new body has moved")


func free_nodes() -> void:
	Engine.print_error_messages = true
	_free_objects()
	if _garbage != null:
		_garbage.free_nodes()
	super()


## Makes the calls on new objects, of which the second stays outside the tree, and on [param given].
## Then calls [param check] with each new object.
func _sweep(type: StringName, check: Callable, given: Array[Object] = []) -> void:
	Engine.print_error_messages = false
	_methods = ClassDB.class_get_method_list(type, true)
	_members = ClassDB.class_get_property_list(type, true)
	_signals = ClassDB.class_get_signal_list(type, true)
	if ClassDB.is_parent_class(type, &"Node3D"):
		_members.append_array(ClassDB.class_get_property_list(&"Node3D", true))
	# The first await of a coroutine keeps an object, and the first round what the class caches.
	await wait_frames(1)
	await _call_all(type, check, given)
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	await _call_all(type, check, given)
	Engine.print_error_messages = true
	var left := Performance.get_monitor(Performance.OBJECT_COUNT) - objects
	expect_true(left <= 0.0, "%d objects are left" % left)
	expect_true(_calls >= CALLS, "%d calls are at least %d" % [_calls, CALLS])


func _call_all(type: StringName, check: Callable, given: Array[Object]) -> void:
	var parent := Node3D.new()
	tree.root.add_child(parent)
	_garbage = Garbage.new(SEED + type.hash(), parent)
	var frame := 0
	_calls = 0
	while _calls < CALLS:
		if frame % FRAMES_PER_OBJECT == 0:
			_free_objects()
			_make_objects(type, parent)
		frame += 1
		for i in CALLS_PER_FRAME:
			_call_anything(given)
		await tree.process_frame
	_objects.map(func(object: Object) -> void: check.call(object))
	_free_objects()
	_garbage.free_nodes()
	_garbage = null
	parent.free()
	await wait_frames(2)


func _make_objects(type: StringName, parent: Node) -> void:
	_objects = [ClassDB.instantiate(type), ClassDB.instantiate(type)]
	if _objects[0] is Node:
		parent.add_child(_objects[0] as Node)


func _free_objects() -> void:
	for object in _objects:
		if object is Node:
			object.free()
	_objects.clear()


func _call_anything(given: Array[Object]) -> void:
	var object: Object = _pick(_objects + given)
	var choice := _garbage.random.randf()
	if choice < 0.7:
		var method: Dictionary = _pick(_methods)
		_call(object, method["name"] as StringName, _garbage.arguments_of(method))
	elif choice < 0.9 and not _members.is_empty():
		_assign(object, _pick(_members) as Dictionary)
	elif choice < 0.95 and not _signals.is_empty():
		var emitted: Dictionary = _pick(_signals)
		_call(object, &"emit_signal", [emitted["name"]] + _garbage.arguments_of(emitted))
	elif object is Node and object not in given:
		_call(object, &"notification", [_pick(SAFE_NOTIFICATIONS)])
	else:
		_call_connections(object)


func _pick(values: Array) -> Variant:
	return values[_garbage.random.randi() % values.size()]


func _call(object: Object, method: StringName, arguments: Array) -> void:
	if _trace:
		print("CALL %d %s.%s %s" % [_calls, object, method, str(arguments).left(300)])
	_calls += 1
	_garbage.reuse(object.callv(method, arguments))


func _assign(object: Object, member: Dictionary) -> void:
	var title: StringName = member["name"]
	var type: int = member["type"]
	var value: Variant = _garbage.of_type(type) if _garbage.random.randf() < 0.7 else _garbage.any()
	if _trace:
		print("SET %d %s.%s %s" % [_calls, object, title, str(value).left(300)])
	_calls += 1
	object.set(title, value)
	_garbage.reuse(object.get(title))


## Calls what the object has connected to signals.
func _call_connections(object: Object) -> void:
	for connection in object.get_incoming_connections():
		var callable: Callable = connection["callable"]
		var arguments := []
		for i in _garbage.random.randi() % 3:
			arguments.append(_garbage.any())
		if _trace:
			print("CALLABLE %d %s %s" % [_calls, callable, str(arguments).left(300)])
		_calls += 1
		callable.callv(arguments)
