extends "res://tests/framework/test_case.gd"
## Which threads may use which classes: a call from a wrong thread is an error and does nothing.

const BUSY := (
	"%s: two threads call methods of one object at the same time. This call did nothing. Use one "
	+ "object for each thread, or a Mutex."
)
const IN_TREE := (
	"%s: a thread other than the main thread calls a method of a node in the tree. This call did "
	+ "nothing. Use call_deferred()."
)
const DRAWN := (
	"GANode3D %s: another thread changed its scene or multivector, which is not drawn. Change what "
	+ "a node draws in the main thread, for example by call_deferred()."
)


## Calls back when it is moved, in the middle of MotorPool.apply_to_nodes().
class Listener:
	extends Node3D
	var callback := Callable()

	func _init() -> void:
		set_notify_local_transform(true)

	func _notification(what: int) -> void:
		if what == NOTIFICATION_LOCAL_TRANSFORM_CHANGED and callback.is_valid():
			callback.call()


## The result of a call in another thread.
static func in_thread(callable: Callable) -> Variant:
	var thread := Thread.new()
	thread.start(callable)
	return thread.wait_to_finish()


func test_a_pool_in_two_threads() -> void:
	var pool := MotorPool.new()
	var index := pool.acquire()
	var results := []
	var listener := Listener.new()
	add_node(listener)
	listener.callback = func() -> void:
		results.append(in_thread(pool.acquire))
		results.append(in_thread(pool.get_count))
		results.append(pool.get_count())
	pool.set_from(index, Transform3D(Basis(), Vector3.ONE))
	pool.set_to(index, Transform3D(Basis(), Vector3.ONE))
	pool.interpolate(0.0, MultivectorLerp.LINEAR)
	var nodes: Array[Node3D] = [listener]
	expect_error(BUSY % "MotorPool", 2)
	pool.apply_to_nodes(nodes)
	expect_equal(results, [-1, 0, 1], "results of the other thread, and of the callback")
	# One after the other is allowed.
	expect_equal(in_thread(pool.get_count), 1, "count")


func test_a_scene_in_two_threads() -> void:
	var scene := GAScene.new()
	var results := []
	scene.entries_changed.connect(
		func(_names: PackedStringArray) -> void:
			results.append(in_thread(scene.add_entry.bind("q", "2")))
			results.append(in_thread(scene.get_names))
			results.append(scene.get_names()),
		CONNECT_ONE_SHOT
	)
	expect_error(BUSY % "GAScene", 2)
	scene.add_entry("p", "1")
	expect_equal(
		results,
		[ERR_BUSY, PackedStringArray(), PackedStringArray(["p"])],
		"results of the other thread, and of the callback"
	)


func test_a_receiver_in_two_threads() -> void:
	var receiver := MotorReceiver.new()
	var results := []
	receiver.body_added.connect(
		func(_id: int) -> void:
			results.append(in_thread(receiver.accept.bind(PackedByteArray(), 0.0)))
			results.append(receiver.has_body(3)),
		CONNECT_ONE_SHOT
	)
	expect_error(BUSY % "MotorReceiver")
	_stream(receiver, 0)
	expect_equal(results, ["another thread is using this object", true], "results")


## Each thread has its own sender, receiver, codec, pool and scene, and all compute the same.
func test_objects_of_different_threads() -> void:
	var threads: Array[Thread] = []
	for i in 4:
		threads.append(Thread.new())
		threads[i].start(_compute.bind(i))
	var results := threads.map(func(thread: Thread) -> Variant: return thread.wait_to_finish())
	for i in 4:
		expect_equal(results[i], _compute(i), "results of thread %d" % i)


func test_nodes_in_the_tree() -> void:
	var target := Node3D.new()
	target.name = "Target"
	add_node(target)
	var synchronizer := MotorSynchronizer.new()
	in_thread(synchronizer.add_target.bind(target))
	add_node(synchronizer)
	await wait_frames(3)
	expect_equal(synchronizer.get_active_targets().size(), 1, "a thread prepared the node")
	expect_error(IN_TREE % "MotorSynchronizer", 3)
	in_thread(synchronizer.remove_target.bind(target))
	in_thread(synchronizer.set.bind(&"send_rate", 5.0))
	expect_equal(in_thread(synchronizer.get_statistics), {}, "statistics")
	await wait_frames(3)
	expect_equal(synchronizer.get_active_targets().size(), 1, "targets")
	expect_equal(synchronizer.send_rate, 20.0, "send_rate")
	var mover := MultivectorLerp.new()
	in_thread(mover.set.bind(&"duration", 3.0))
	add_node(mover)
	expect_error(IN_TREE % "MultivectorLerp")
	in_thread(mover.set.bind(&"duration", 5.0))
	expect_equal(mover.duration, 3.0, "duration")


func test_what_a_node_draws() -> void:
	var node := GANode3D.new()
	node.name = "Drawn"
	node.scene = GAScene.new()
	node.entry = &"p"
	add_node(node)
	await wait_frames(2)
	expect_error(DRAWN % "Drawn")
	in_thread(node.scene.add_entry.bind("p", "point(1, 2, 3)"))
	expect_error(IN_TREE % "GANode3D")
	in_thread(node.set.bind(&"entry", "q"))
	expect_equal(node.entry, &"p", "entry")


## Multivectors that no thread changes can be shared.
func test_multivectors_are_shared() -> void:
	var motor := Multivector.motor(Transform3D(Basis(Vector3.UP, 1.0), Vector3(1, 2, 3)))
	var work := func() -> String:
		var point := Multivector.point(Vector3.ONE)
		for i in 200:
			point = motor.sandwich(point)
		return (
			"%s %s" % [point.to_json(), Multivector.evaluate("sphere(point(1, 2, 3), 2)").to_json()]
		)
	var threads: Array[Thread] = []
	for i in 4:
		threads.append(Thread.new())
		threads[i].start(work)
	for thread in threads:
		expect_equal(thread.wait_to_finish(), work.call(), "result")


func _compute(seed_value: int) -> Array:
	var receiver := MotorReceiver.new()
	_stream(receiver, seed_value)
	var codec := MotorCodec.new()
	var transforms: Array[Transform3D] = [Transform3D(Basis(), Vector3(seed_value, 1, 2))]
	var packet := codec.encode(PackedInt32Array([1]), transforms)
	var pool := MotorPool.new()
	for i in 100:
		pool.set_to(pool.acquire(), transforms[0])
	pool.interpolate(0.5, MultivectorLerp.SCREW)
	var scene := GAScene.new()
	for i in 20:
		scene.add_entry("p%d" % i, "point(%d, 2, 3)" % i if i == 0 else "p%d + p0" % (i - 1))
	scene.set_expression("p0", "point(%d, 1, 1)" % seed_value)
	return [
		receiver.get_transform(3),
		packet,
		codec.decode(packet)["transforms"],
		pool.get_buffer(),
		scene.get_value("p19").coefficients
	]


## Sends the motion of body 3 to a receiver.
static func _stream(receiver: MotorReceiver, seed_value: int) -> void:
	var sender := MotorSender.new()
	sender.add_body(3, Transform3D.IDENTITY)
	sender.add_receiver(0, 0.0)
	for tick in 90:
		var now := tick / 60.0
		sender.observe(3, now, Transform3D(Basis(), Vector3(seed_value + sin(now), 0, 0)))
		for packet in sender.flush(now):
			receiver.accept(packet["bytes"] as PackedByteArray, now)
		receiver.advance(now)
		sender.accept(0, receiver.take_ack(now), now)
