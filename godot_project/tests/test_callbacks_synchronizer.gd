extends "res://tests/framework/network_test.gd"
## Callbacks of targets and handlers of signals free and change what MotorSynchronizer works on.

const NotifyingNode := preload("res://tests/framework/notifying_node.gd")
const BODIES := 24
## Nodes that a callback adds: more than fit where the targets are.
const MANY := 100


class FreeingLogger:
	extends Logger
	## Frees a node when an error is logged.

	var node: Node
	## After free(), while the code that has logged the error is on the stack.
	var is_in_memory := false

	func _log_error(
		_function: String,
		_file: String,
		_line: int,
		_code: String,
		_rationale: String,
		_editor_notify: bool,
		_error_type: int,
		_script_backtraces: Array[ScriptBacktrace]
	) -> void:
		if is_instance_valid(node) and not node.is_queued_for_deletion():
			node.free()
			is_in_memory = is_instance_valid(node)


var _others: Array[MotorSynchronizer] = []


func test_a_target_frees_the_synchronizer() -> void:
	await _on_first_move(func() -> void: branches[1].synchronizer.free(), false)
	var synchronizer: Variant = branches[1].synchronizer
	expect_true(not is_instance_valid(synchronizer), "the synchronizer is freed")


func test_a_target_frees_the_other_synchronizers() -> void:
	await connect_peers(1, BODIES)
	for i in 8:
		var other := MotorSynchronizer.new()
		other.target_group = &"others"
		other.max_latency = branches[1].synchronizer.max_latency
		branches[1].world.add_child(other)
		_others.append(other)
		var body := Node3D.new()
		body.name = "Other%d" % i
		body.add_to_group(&"others")
		branches[1].world.add_child(body)
	await wait_frames(3)
	await _on_first_move(
		func() -> void:
			for other in _others:
				other.free()
			_others.clear()
			for i in MANY:
				_add_target("More%d" % i)
	)
	expect_equal(branches[1].synchronizer.get_active_targets().size(), BODIES + MANY, "targets")


func test_a_target_adds_targets() -> void:
	await _on_first_move(
		func() -> void:
			for i in MANY:
				_add_target("More%d" % i)
	)
	expect_equal(branches[1].synchronizer.get_active_targets().size(), BODIES + MANY, "targets")
	expect_true(distance_from_path(branches[1].get_body(1)) < 0.1, "the targets still move")


func test_a_target_removes_the_scene() -> void:
	await _on_first_move(func() -> void: branches[1].root.remove_child(branches[1].world), false)
	expect_equal(branches[1].synchronizer.get_active_targets().size(), 0, "targets")
	branches[1].root.add_child(branches[1].world)
	await move(branches[0], 2.0 * SETTLE)
	expect_equal(branches[1].synchronizer.get_active_targets().size(), BODIES, "targets")


func test_the_end_of_a_hidden_target_frees_the_synchronizer() -> void:
	await connect_peers(1, BODIES)
	await move(branches[0], SETTLE)
	# No pose of this one is known, so that it is hidden.
	var body := branches[1].add_body("Body%d" % BODIES)
	await wait_until(func() -> bool: return not body.visible, "the body to be hidden")
	var synchronizer := branches[1].synchronizer
	body.visibility_changed.connect(func() -> void: synchronizer.free(), CONNECT_ONE_SHOT)
	synchronizer.remove_target(body)
	expect_true(body.visible, "the body is shown again")
	await wait_frames(2)
	expect_true(not is_instance_valid(synchronizer), "the synchronizer is freed")


func test_a_logger_frees_the_synchronizer() -> void:
	await connect_peers(1, BODIES)
	await move(branches[0], SETTLE)
	var synchronizer := branches[0].synchronizer
	var path := String(synchronizer.get_path())
	var logger := FreeingLogger.new()
	logger.node = synchronizer
	OS.add_logger(logger)
	var body := branches[0].get_body(0)
	expect_error(
		(
			(
				"MotorSynchronizer %s: the transform of %s is mirrored (negative scale), which a motor "
				+ "cannot represent; mirror a child node instead. Other peers keep seeing its last pose."
			)
			% [path, body.get_path()]
		)
	)
	body.scale = Vector3(1, 1, -1)
	await wait_frames(4)
	OS.remove_logger(logger)
	expect_true(logger.is_in_memory, "the synchronizer stays in memory during the callback")
	expect_true(not is_instance_valid(synchronizer), "the synchronizer is freed")


func test_handlers_of_target_removed_change_targets() -> void:
	await connect_peers(1, BODIES)
	await move(branches[0], 0.1)
	var client := branches[1]
	client.synchronizer.target_removed.connect(
		func(_node: Node) -> void:
			for i in range(1, BODIES):
				client.synchronizer.remove_target(client.get_body(i))
			for i in MANY:
				_add_target("More%d" % i),
		CONNECT_ONE_SHOT
	)
	client.get_body(0).free()
	expect_equal(client.synchronizer.get_active_targets().size(), MANY, "targets")
	await move(branches[0], SETTLE)


func free_nodes() -> void:
	for other in _others:
		other.free()
	super()


func _add_target(body_name: String) -> void:
	var body := Node3D.new()
	body.name = body_name
	branches[1].root.add_child(body)
	branches[1].synchronizer.add_target(body)


## Moves the server's bodies and calls the callback once, when the client moves its first body.
func _on_first_move(callback: Callable, stays := true) -> void:
	if branches.is_empty():
		await connect_peers(1, BODIES)
	var client := branches[1]
	var synchronizer := client.synchronizer
	await move(branches[0], SETTLE)
	var body := client.get_body(0)
	body.set_script(NotifyingNode)
	body.set(
		&"moved",
		func(_node: Node) -> void:
			body.set(&"moved", Callable())
			callback.call()
	)
	await wait_frames(1)
	await move(branches[0], SETTLE)
	expect_equal(body.get(&"moved"), Callable(), "the callback that is left")
	if stays:
		expect_true(synchronizer.is_inside_tree(), "the synchronizer stays")
		await move(branches[0], SETTLE)
