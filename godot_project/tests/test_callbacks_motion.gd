extends "res://tests/framework/test_case.gd"
## Callbacks of the nodes that MotorPool and MultivectorLerp move free and change their objects.

const NotifyingNode := preload("res://tests/framework/notifying_node.gd")
const COUNT := 64

var _pool := MotorPool.new()
var _indices := PackedInt64Array()
var _moved: Array[Node3D] = []
var _world := Node3D.new()
var _target := NotifyingNode.new()
var _lerp := MultivectorLerp.new()


func test_a_node_frees_all_other_nodes() -> void:
	_fill()
	_on_first_move(
		func(first: Node) -> void:
			for node: Node in _moved.duplicate():
				if node != first:
					node.free()
	)
	_pool.apply_to_nodes(_moved)
	expect_equal(_moved[0].position, _position_of(0), "position of the first node")
	expect_true(not is_instance_valid(_moved[1]), "the second node is freed")


func test_nodes_after_a_freed_one_are_moved() -> void:
	_fill()
	_on_first_move(func(_first: Node) -> void: _moved[5].free())
	_pool.apply_to_nodes(_moved)
	expect_equal(_moved[6].position, _position_of(6), "position of a later node")
	expect_equal(_moved[-1].position, _position_of(COUNT - 1), "position of the last node")


func test_a_node_changes_the_pool() -> void:
	var changes: Dictionary[String, Callable] = {
		"acquire": _acquire_many,
		"release": _release_all,
		"clear": func() -> void: _pool.clear(),
		"clear and acquire": _clear_and_acquire,
		"reserve": func() -> void: _pool.reserve(100 * COUNT),
		"interpolate": func() -> void: _pool.interpolate(0.0, MultivectorLerp.SCREW),
		"get_buffer": func() -> void: _pool.get_buffer(),
		"apply to others": func() -> void: _apply_to_others(_pool),
	}
	for change in changes:
		_pool = MotorPool.new()
		_indices.clear()
		_moved.clear()
		_fill()
		_on_first_move(func(_first: Node) -> void: changes[change].call())
		_pool.apply_to_nodes(_moved)
		# All nodes get the poses of the time of the call.
		for i in COUNT:
			expect_equal(
				_moved[i].position, _position_of(i), "%s: position of node %d" % [change, i]
			)


func test_a_node_applies_the_pool_again() -> void:
	_fill()
	_on_first_move(
		func(_first: Node) -> void:
			_moved.reverse()
			_pool.apply_to_nodes(_moved)
			_moved.reverse()
	)
	_pool.apply_to_nodes(_moved)
	expect_equal(_moved[0].position, _position_of(COUNT - 1), "position of the first node")
	for i in range(1, COUNT):
		expect_equal(_moved[i].position, _position_of(i), "position of node %d" % i)


func test_a_node_releases_the_pool_and_the_list() -> void:
	_fill()
	var known := _moved.duplicate()
	var others: Array[MotorPool] = []
	_on_first_move(
		func(_first: Node) -> void:
			_pool = null
			_moved.clear()
			_moved.resize(1000)
			# Others reuse the memory.
			for i in 8:
				var other := MotorPool.new()
				for k in COUNT:
					other.acquire()
				_apply_to_others(other)
				others.append(other)
	)
	_pool.apply_to_nodes(_moved)
	expect_null(_pool, "the pool")
	expect_equal(
		(known[-1] as Node3D).position, _position_of(COUNT - 1), "position of the last node"
	)


func test_the_target_frees_the_lerp() -> void:
	for local: bool in [false, true]:
		_make_lerp()
		_lerp.local = local
		_lerp.play()
		_target.moved = func(_node: Node) -> void: _lerp.free()
		await wait_frames(3)
		expect_true(not is_instance_valid(_lerp), "the lerp is freed")
		_reset()


func test_the_target_frees_the_lerp_that_becomes_ready() -> void:
	_target.moved = func(_node: Node) -> void: _lerp.free()
	expect_error(
		(
			"Parent node is busy adding/removing children, `remove_child()` can't be called at this "
			+ "time. Consider using `remove_child.call_deferred(child)` instead."
		)
	)
	_make_lerp()
	await wait_frames(2)
	expect_true(not is_instance_valid(_lerp), "the lerp is freed")


func test_the_target_frees_the_lerp_in_a_call() -> void:
	_make_lerp()
	await wait_frames(2)
	var id := _lerp.get_instance_id()
	_target.moved = func(_node: Node) -> void: _lerp.free()
	_lerp.factor = 0.5
	expect_true(not _lerp.is_inside_tree(), "the lerp has left the tree")
	expect_true(_lerp.is_queued_for_deletion(), "the lerp is freed at the end of the frame")
	await wait_frames(2)
	expect_true(not is_instance_id_valid(id), "the lerp is freed")


func free_nodes() -> void:
	super()
	for node: Variant in [_world, _target, _lerp]:
		if is_instance_valid(node):
			(node as Node).free()


func _position_of(i: int) -> Vector3:
	return Vector3(i, 2 * i, -i)


func _fill() -> void:
	for i in COUNT:
		_indices.append(_pool.acquire())
		_pool.set_from(_indices[i], Transform3D(Basis.IDENTITY, Vector3.ONE))
		_pool.set_to(_indices[i], Transform3D(Basis.IDENTITY, _position_of(i)))
		var node := NotifyingNode.new()
		add_node(node)
		_moved.append(node)
	_pool.interpolate(1.0, MultivectorLerp.LINEAR)


## Calls the callback once, with the first node, when the pool moves that.
func _on_first_move(callback: Callable) -> void:
	var first := _moved[0] as NotifyingNode
	first.moved = func(_node: Node) -> void:
		first.moved = Callable()
		callback.call(first)


func _acquire_many() -> void:
	for i in 10 * COUNT:
		_pool.acquire()


func _release_all() -> void:
	for index in _indices:
		_pool.release(index)
	_pool.acquire()


func _clear_and_acquire() -> void:
	_pool.clear()
	_acquire_many()


func _apply_to_others(pool: MotorPool) -> void:
	var others: Array[Node3D] = []
	for i in COUNT:
		var node := Node3D.new()
		add_node(node)
		others.append(node)
	pool.apply_to_nodes(others)


func _make_lerp() -> void:
	for end: String in ["Start", "End"]:
		var node := Node3D.new()
		node.name = end
		node.position = Vector3.ONE if end == "Start" else Vector3(2, 3, 4)
		_world.add_child(node)
	_target.name = "Target"
	_world.add_child(_target)
	_lerp.start = ^"../Start"
	_lerp.end = ^"../End"
	_lerp.target = ^"../Target"
	_world.add_child(_lerp)
	add_node(_world)


func _reset() -> void:
	free_nodes()
	_world = Node3D.new()
	_target = NotifyingNode.new()
	_lerp = MultivectorLerp.new()
