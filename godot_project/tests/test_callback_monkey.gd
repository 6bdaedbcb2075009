extends "res://tests/framework/network_test.gd"
## Random actions within the callbacks and signal handlers that random actions cause. Nothing may
## crash; errors are expected.

const Monkey := preload("res://tests/framework/callback_monkey.gd")
const SEEDS := [1, 2, 3]
const STEPS := 3000
const FRAMES := 300
const ACTIONS_PER_FRAME := 4

var _monkey := Monkey.new()
var _pools: Array[MotorPool] = []
var _nodes_of_pools: Array[Node3D] = []
var _bodies_and_synchronizers: Array[Node] = []
var _lerps: Array[MultivectorLerp] = []
var _scenes: Array[GAScene] = []
var _drawings: Array[GANode3D] = []
var _world: Node3D
var _multimesh := MultiMesh.new()


func test_pools_and_lerps() -> void:
	_multimesh.transform_format = MultiMesh.TRANSFORM_3D
	await _run([_act_on_pool, _act_on_pool, _act_on_node, _act_on_lerp], STEPS, 20)
	expect_true(_monkey.nested > STEPS / 8, "%d actions within callbacks" % _monkey.nested)


func test_scenes_and_drawings() -> void:
	await _run([_act_on_scene, _act_on_scene, _act_on_drawing], STEPS, 20)
	expect_true(_monkey.nested > STEPS / 8, "%d actions within callbacks" % _monkey.nested)


func test_synchronizers_offline() -> void:
	make_branch("Offline")
	branches[0].api.multiplayer_peer = OfflineMultiplayerPeer.new()
	branches[0].start()
	await _run([_act_on_synchronizer, _act_on_body], FRAMES * ACTIONS_PER_FRAME, ACTIONS_PER_FRAME)
	expect_true(_monkey.nested > FRAMES / 8, "%d actions within callbacks" % _monkey.nested)


func test_synchronizers_of_two_peers() -> void:
	await connect_peers(1, 0)
	await _run(
		[_act_on_synchronizer, _act_on_body, _act_on_body, _act_on_body, _act_on_connection],
		FRAMES * ACTIONS_PER_FRAME,
		ACTIONS_PER_FRAME
	)
	expect_true(_monkey.nested > FRAMES / 8, "%d actions within callbacks" % _monkey.nested)


func free_nodes() -> void:
	if is_instance_valid(_world):
		_world.free()
	# Nodes that were made while there was no world, or while it did not accept children.
	for nodes: Array in [_nodes_of_pools, _bodies_and_synchronizers, _lerps, _drawings]:
		for node: Variant in nodes:
			if is_instance_valid(node):
				(node as Node).free()
		nodes.clear()
	_pools.clear()
	_scenes.clear()
	_monkey.actions.clear()
	for branch in branches:
		if not branch.api.has_multiplayer_peer():
			branch.api.multiplayer_peer = OfflineMultiplayerPeer.new()
	super()


## Performs the actions, with all seeds together [param steps] times.
func _run(actions: Array[Callable], steps: int, steps_per_frame: int) -> void:
	Engine.print_error_messages = false
	_monkey.actions = actions
	for number: int in SEEDS:
		_monkey.random.seed = number
		for step in steps / SEEDS.size():
			if not is_instance_valid(_world):
				_world = Node3D.new()
				tree.root.add_child(_world)
			_monkey.act()
			if step % steps_per_frame == 0:
				await tree.process_frame
		_pools.clear()
		_scenes.clear()
		if is_instance_valid(_world):
			_world.free()
		await wait_frames(2)
	_monkey.stop()
	Engine.print_error_messages = true
	error_log.take_faults()
	expect_true(true, "the end is reached")


func _alive(from: Array) -> Array:
	return from.filter(func(node: Variant) -> bool: return is_instance_valid(node))


func _act_on_pool() -> void:
	if _pools.size() < 2:
		_pools.append(MotorPool.new())
	var pool: MotorPool = _monkey.pick(_pools)
	var nodes: Array[Node3D] = []
	nodes.assign(_alive(_nodes_of_pools))
	match _monkey.random.randi_range(0, 12):
		0, 1, 2:
			pool.set_to(pool.acquire(), _monkey.transform())
		3:
			pool.release(_monkey.random.randi_range(0, 8))
		4:
			if _monkey.random.randi_range(0, 9) == 0:
				pool.clear()
		5:
			pool.reserve(_monkey.random.randi_range(0, 5000))
		6:
			_pools.erase(pool)
		7:
			_multimesh.instance_count = pool.get_count() + _monkey.random.randi_range(0, 1)
			pool.apply_to_multimesh(_multimesh)
		8:
			pool.get_buffer()
			pool.interpolate(_monkey.random.randf(), MultivectorLerp.SCREW)
		_:
			while pool.get_count() < nodes.size():
				pool.set_from(pool.acquire(), _monkey.transform())
			pool.interpolate(_monkey.random.randf(), MultivectorLerp.LINEAR)
			if nodes.is_empty():
				return
			while nodes.size() < pool.get_count():
				nodes.append(_monkey.pick(nodes) as Node3D)
			_pools.shuffle()
			pool.apply_to_nodes(nodes)


func _act_on_node() -> void:
	_nodes_of_pools.assign(_alive(_nodes_of_pools))
	if _nodes_of_pools.size() < 12:
		var node := _monkey.make_node()
		_nodes_of_pools.append(node)
		if is_instance_valid(_world):
			_world.add_child(node)
		return
	var chosen: Node3D = _monkey.pick(_nodes_of_pools)
	match _monkey.random.randi_range(0, 4):
		0, 1:
			_monkey.free_node(chosen)
		2:
			chosen.visible = not chosen.visible
		3:
			_monkey.reparent(chosen, _monkey.pick(_nodes_of_pools) as Node)
		4:
			chosen.transform = _monkey.transform()


func _act_on_lerp() -> void:
	_lerps.assign(_alive(_lerps))
	if _lerps.size() < 4:
		var made := MultivectorLerp.new()
		made.auto_play = true
		made.duration = 0.02
		_monkey.watch(made, [&"finished"])
		for property: StringName in [&"start", &"end", &"target"]:
			_link(made, property)
		_lerps.append(made)
		if is_instance_valid(_world):
			_world.add_child(made)
		return
	var chosen: MultivectorLerp = _monkey.pick(_lerps)
	match _monkey.random.randi_range(0, 7):
		0:
			chosen.free()
		1:
			chosen.factor = _monkey.random.randf()
		2:
			chosen.local = not chosen.local
		3:
			chosen.play()
		4:
			chosen.start_motor = Multivector.motor(_monkey.transform())
		5:
			chosen.end_motor = null
		_:
			_link(chosen, _monkey.pick([&"start", &"end", &"target"]) as StringName)


func _link(chosen: MultivectorLerp, property: StringName) -> void:
	var node: Node3D = _monkey.pick(_alive(_nodes_of_pools))
	if node != null and node.is_inside_tree():
		chosen.set(property, node.get_path())


func _act_on_scene() -> void:
	if _scenes.size() < 2:
		var made := GAScene.new()
		_monkey.watch(made, [&"entries_changed", &"changed"])
		_scenes.append(made)
	var chosen: GAScene = _monkey.pick(_scenes)
	var entry: String = _monkey.pick(["a", "b", "c"])
	match _monkey.random.randi_range(0, 9):
		0, 1, 2:
			chosen.add_entry(entry, "point(%d, 2, 3)" % _monkey.random.randi_range(0, 9))
		3:
			chosen.rename_entry(entry, _monkey.pick(["a", "b", "d"]) as String)
		4:
			chosen.remove_entry(entry)
		5:
			chosen.load_json((_monkey.pick(_scenes) as GAScene).to_json())
		6:
			chosen.load_json('{"entries": [{"name": "a", "expression": "e1"}, 3]}')
		7:
			_scenes.erase(chosen)
		8:
			chosen.set_entry_attribute(entry, "visible", _monkey.random.randi_range(0, 1) == 1)
		9:
			chosen.set_parameter(entry, "x", _monkey.random.randf())


func _act_on_drawing() -> void:
	_drawings.assign(_alive(_drawings))
	if _drawings.size() < 6:
		var made := GANode3D.new()
		_monkey.watch(
			made, [&"visibility_changed", &"child_entered_tree", &"tree_exiting", &"tree_entered"]
		)
		made.show_label = true
		_drawings.append(made)
		if is_instance_valid(_world):
			_world.add_child(made)
		return
	var chosen: GANode3D = _monkey.pick(_drawings)
	match _monkey.random.randi_range(0, 8):
		0:
			if not chosen.is_queued_for_deletion():
				chosen.queue_free()
		1, 2:
			chosen.scene = _monkey.pick(_scenes)
			chosen.entry = _monkey.pick([&"a", &"b"])
		3:
			chosen.label = str(_monkey.count)
		4:
			chosen.show_label = not chosen.show_label
		5:
			for label in chosen.get_children(true):
				label.queue_free()
		6:
			chosen.visible = not chosen.visible
		7:
			chosen.update_drawing()
		8:
			for label: Node3D in chosen.get_children(true):
				if not label.visibility_changed.has_connections():
					_monkey.watch(label, [&"visibility_changed"])


func _act_on_synchronizer() -> void:
	var branch: NetworkBranch = _monkey.pick(branches)
	var found := branch.world.find_children("*", "MotorSynchronizer", true, false)
	if found.size() < 2:
		var made := MotorSynchronizer.new()
		made.name = "Motors%d" % _monkey.count
		made.target_group = _monkey.pick([&"bodies", &"others"])
		_bodies_and_synchronizers.append(made)
		_monkey.watch(
			made, [&"target_added", &"target_removed", &"target_ended", &"packet_rejected"]
		)
		branch.world.add_child(made)
		return
	var chosen: MotorSynchronizer = _monkey.pick(found)
	var body: Node3D = _monkey.pick(branch.world.find_children("Body*", "Node3D", true, false))
	match _monkey.random.randi_range(0, 13):
		0:
			chosen.free()
		1:
			chosen.get_parent().remove_child(chosen)
			chosen.free()
		2:
			chosen.position_tolerance = _monkey.random.randf_range(0.001, 0.01)
		3:
			chosen.relay = not chosen.relay
		4:
			chosen.target_group = _monkey.pick([&"bodies", &"others", &""])
		5:
			chosen.get_statistics()
		6:
			chosen.get_setup_warnings()
		7:
			chosen.notification(Node.NOTIFICATION_INTERNAL_PROCESS)
			chosen.notification(Node.NOTIFICATION_INTERNAL_PHYSICS_PROCESS)
		8:
			if body != null:
				chosen.free_target(body)
		9:
			if body != null:
				chosen.teleport(body)
		10, 11:
			if body != null:
				chosen.remove_target(body)
		_:
			if body != null:
				chosen.add_target(body)


func _act_on_body() -> void:
	var branch: NetworkBranch = _monkey.pick(branches)
	var bodies := branch.world.find_children("Body*", "Node3D", true, false)
	if bodies.size() < 8:
		var made := _monkey.make_node()
		made.name = "Body%d" % _monkey.random.randi_range(0, 12)
		made.add_to_group(&"bodies")
		_bodies_and_synchronizers.append(made)
		branch.world.add_child(made)
		return
	var body: Node3D = _monkey.pick(bodies)
	match _monkey.random.randi_range(0, 9):
		0:
			_monkey.free_node(body)
		1:
			body.name = "Body%d" % _monkey.random.randi_range(0, 12)
		2:
			_monkey.reparent(body, _monkey.pick(bodies) as Node)
		3:
			_monkey.reparent(body, branch.world)
		4:
			body.set_multiplayer_authority(branch.api.get_unique_id())
		5:
			body.set_multiplayer_authority(1)
		6:
			body.add_to_group(&"others")
		7:
			body.visible = not body.visible
		_:
			body.transform = _monkey.transform()


func _act_on_connection() -> void:
	var branch: NetworkBranch = _monkey.pick(branches)
	match _monkey.random.randi_range(0, 30):
		0:
			branches[1].api.multiplayer_peer.close()
		1:
			branches[1].api.multiplayer_peer = OfflineMultiplayerPeer.new()
		2:
			branches[1].api.multiplayer_peer = null
		3, 4, 5, 6, 7, 8:
			var peer: ENetMultiplayerPeer = branches[0].api.multiplayer_peer
			if not branches[1].api.has_multiplayer_peer() or not branches[1].is_joined():
				branches[1].join(peer.host.get_local_port())
		9, 10, 11:
			branch.api.poll()
		12:
			tree.physics_frame.emit()
		13, 14:
			var packet := PackedByteArray([0x46, 1, 2, 3])
			if branch.api.has_multiplayer_peer() and not branch.api.get_peers().is_empty():
				branch.api.send_bytes(packet, 0, MultiplayerPeer.TRANSFER_MODE_RELIABLE)
