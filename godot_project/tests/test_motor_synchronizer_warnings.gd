extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: warnings about the scene, in the Scene dock and at run time.


func test_warnings() -> void:
	var scene := Node3D.new()
	scene.name = "Scene"
	add_node(scene)
	var node := MotorSynchronizer.new()
	scene.add_child(node)
	_expect_warnings(
		node,
		[
			(
				'Nothing is replicated. Assign "targets", set "target_group", or call '
				+ "add_target() from a script."
			)
		]
	)
	node.targets = [^"../Missing", ^".."]
	_expect_warnings(node, ['targets[0] ("../Missing") is not the path of a Node3D or Node2D.'])
	node.targets = []
	node.target_group = &"empty"
	_expect_warnings(
		node,
		[
			(
				'No Node3D or Node2D of this scene is in the group "empty". This is correct only if '
				+ "all of its members are spawned later."
			)
		]
	)
	var body := RigidBody3D.new()
	body.name = "Crate"
	body.add_to_group(&"empty")
	scene.add_child(body)
	_expect_warnings(
		node,
		[
			(
				"Crate is a RigidBody3D that every peer would simulate. Set freeze, with "
				+ "freeze_mode Kinematic, and unfreeze it only where is_multiplayer_authority() is "
				+ "true."
			)
		]
	)
	body.freeze = true
	_expect_warnings(node, [])
	var other := MotorSynchronizer.new()
	other.name = "Other"
	other.targets = [^"../Crate"]
	scene.add_child(other)
	_expect_warnings(node, ["Crate is also a target of Other. Remove it from one of the two."])
	other.free()
	var synchronizer := MultiplayerSynchronizer.new()
	synchronizer.name = "Sync"
	synchronizer.replication_config = SceneReplicationConfig.new()
	synchronizer.replication_config.add_property(^"Crate:visible")
	scene.add_child(synchronizer)
	_expect_warnings(node, [])
	# A MultiplayerSpawner's state at the spawn is no second stream.
	synchronizer.replication_config.add_property(^"Crate:position")
	synchronizer.replication_config.property_set_spawn(^"Crate:position", true)
	synchronizer.replication_config.property_set_replication_mode(
		^"Crate:position", SceneReplicationConfig.REPLICATION_MODE_NEVER
	)
	_expect_warnings(node, [])
	synchronizer.replication_config.add_property(^"Crate:position:y")
	_expect_warnings(
		node,
		[
			(
				"The MultiplayerSynchronizer Sync also replicates position of Crate. Remove the "
				+ "property there."
			)
		]
	)


func test_warning_of_a_send_rate_above_the_tick_rate() -> void:
	var node := _add_synchronizer(Node3D.new())
	node.send_rate = 60.0
	_expect_warnings(node, [])
	await _settle()
	var warning := (
		"send_rate is 90.0 Hz, but there are only 60 physics ticks per second, and motion is sent at "
		+ "most once per tick. Reduce send_rate or raise Engine.physics_ticks_per_second."
	)
	expect_warning("MotorSynchronizer: " + warning)
	node.send_rate = 90.0
	_expect_warnings(node, [warning])
	node.send_rate = 91.0
	node.send_rate = 60.0
	Engine.physics_ticks_per_second = 120
	node.send_rate = 120.0
	Engine.physics_ticks_per_second = 60
	node.send_rate = 60.0


func test_warning_of_targets_in_a_sub_thread() -> void:
	var target := Node3D.new()
	target.name = "Boat"
	var group := Node3D.new()
	group.name = "Threaded"
	group.add_child(target)
	group.process_thread_group = Node.PROCESS_THREAD_GROUP_SUB_THREAD
	var node := _add_synchronizer(group, ^"../Threaded/Boat")
	var warning := (
		"Boat runs in a sub-thread, where the engine refuses multiplayer calls such as "
		+ "is_multiplayer_authority(). Set process_thread_group of Threaded to Main Thread."
	)
	_expect_warnings(node, [warning])
	expect_warning("MotorSynchronizer: " + warning)
	await _settle()
	_expect_warnings(node, [warning])
	target.process_thread_group = Node.PROCESS_THREAD_GROUP_MAIN_THREAD
	node.get_parent().remove_child(node)
	add_node(node)


func test_error_of_a_synchronizer_in_a_sub_thread() -> void:
	var target := Node3D.new()
	target.name = "Boat"
	var node := _add_synchronizer(target, ^"../Boat")
	await _settle()
	node.name = "Motors"
	node.process_thread_group = Node.PROCESS_THREAD_GROUP_SUB_THREAD
	var warning := (
		"Motors runs in a sub-thread, where the engine refuses multiplayer calls such as "
		+ "is_multiplayer_authority(). Set process_thread_group of Motors to Main Thread."
	)
	_expect_warnings(node, [warning])
	expect_error("MotorSynchronizer %s: nothing is replicated. %s" % [node.get_path(), warning])
	await _settle()
	node.process_thread_group = Node.PROCESS_THREAD_GROUP_INHERIT
	await _settle()
	_expect_warnings(node, [])


func test_warning_of_2d_below_3d_and_the_reverse() -> void:
	var space := Node3D.new()
	space.name = "Space"
	var plane := Node2D.new()
	plane.name = "Plane"
	space.add_child(plane)
	var model := Node3D.new()
	model.name = "Model"
	plane.add_child(model)
	var layer := CanvasLayer.new()
	layer.name = "Layer"
	space.add_child(layer)
	var sprite := Node2D.new()
	sprite.name = "Sprite"
	layer.add_child(sprite)
	var node := _add_synchronizer(space)
	node.targets = [^"../Space/Plane", ^"../Space/Plane/Model", ^"../Space/Layer/Sprite"]
	var warnings := [
		(
			"Plane is a Node2D below Space, a Node3D, which does not move it. Give it a parent of "
			+ "its own kind, or a Node."
		),
		(
			"Model is a Node3D below Plane, a Node2D, which does not move it. Give it a parent of "
			+ "its own kind, or a Node."
		),
	]
	_expect_warnings(node, warnings)
	for warning: String in warnings:
		expect_warning("MotorSynchronizer: " + warning)
	await _settle()
	_expect_warnings(node, warnings)


func test_warning_of_automatic_names() -> void:
	await connect_peers(1, 1)
	var server := branches[0]
	for i in 2:
		var body := Node3D.new()
		body.add_to_group(&"bodies")
		server.world.add_child(body)
	var warnings := []
	for i in 2:
		warnings.append(
			(
				(
					"%s has an automatic name, which is different on each peer, so it is not "
					+ "replicated, nor are other nodes with such names. Set its name (and that of "
					+ "its parents) before add_child(), the same on all peers."
				)
				% server.world.get_child(-2 + i).get_path()
			)
		)
	_expect_warnings(server.synchronizer, warnings)
	expect_warning("MotorSynchronizer: %s" % warnings[0])
	await expect_motion(0.2, [branches[1]])
	_expect_warnings(server.synchronizer, warnings)
	expect_equal(
		server.synchronizer.get_active_targets(), [server.get_body(0)] as Array[Node], "targets"
	)
	server.synchronizer.teleport(server.get_body(0))


func test_synchronizers_with_different_settings_warn_once() -> void:
	var node := _add_synchronizer(Node3D.new())
	var warning := (
		"The MotorSynchronizers of this tree have different settings, but share one stream: the "
		+ "smallest tolerances, max_latency and max_packet_size, the highest send_rate, and relay if "
		+ "one of them has it, apply to all of them. Give them the same settings."
	)
	await _settle()
	var ranked := MotorSynchronizer.new()
	ranked.name = "Ranked"
	ranked.priority = 3
	node.get_parent().add_child(ranked)
	await _settle()
	expect_true(not node.get_setup_warnings().has(warning), "different priorities are not a fault")
	for i in 3:
		var other := MotorSynchronizer.new()
		other.name = "Other%d" % i
		other.position_tolerance = 0.01 * (i + 1)
		if i == 0:
			expect_warning("MotorSynchronizer: " + warning)
		node.get_parent().add_child(other)
		await _settle()
	expect_true(node.get_setup_warnings().has(warning), "the warning is in get_setup_warnings()")


func _add_synchronizer(target: Node, path := ^"..") -> MotorSynchronizer:
	var scene := Node.new()
	scene.name = "Scene"
	add_node(scene)
	if target.name.is_empty():
		target.name = "Target"
	scene.add_child(target)
	var node := MotorSynchronizer.new()
	node.name = "Synchronizer"
	node.targets = [NodePath("../" + target.name) if path == ^".." else path]
	scene.add_child(node)
	return node


## Waits for a tick and a frame.
func _settle() -> void:
	for i in 2:
		await tree.physics_frame
		await tree.process_frame


func _expect_warnings(node: MotorSynchronizer, expected: Array) -> void:
	expect_equal(Array(node.get_setup_warnings()), expected, "warnings")
