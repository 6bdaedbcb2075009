extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: properties, configuration warnings, and errors that name the node.


func test_defaults() -> void:
	var node := MotorSynchronizer.new()
	add_node(node)
	expect_near(node.position_tolerance, 0.005, 1e-9, "position_tolerance")
	expect_near(node.rotation_tolerance, 1.4, 1e-9, "rotation_tolerance")
	expect_near(node.max_latency, 0.2, 1e-9, "max_latency")
	expect_near(node.send_rate, 20.0, 1e-9, "send_rate")
	expect_equal(node.mode, MultivectorLerp.SEPARATE, "mode")
	expect_equal(node.target_group, &"", "target_group")
	expect_equal(node.targets, [] as Array[NodePath], "targets")
	expect_equal(node.channel, 0, "channel")
	expect_near(node.least_delay, 0.0, 1e-9, "least_delay")
	expect_near(node.jitter_allowance, 0.2, 1e-9, "jitter_allowance")


func test_invalid_values_change_nothing() -> void:
	var node := MotorSynchronizer.new()
	add_node(node)
	expect_error("MotorSynchronizer: position_tolerance is in metres and positive, not %f." % 0.0)
	node.position_tolerance = 0.0
	expect_error("MotorSynchronizer: rotation_tolerance is in degrees and positive, not %f." % -1.0)
	node.rotation_tolerance = -1.0
	expect_error("MotorSynchronizer: max_latency is in seconds and positive, not inf.")
	node.max_latency = INF
	expect_error("MotorSynchronizer: send_rate is in packets a second and positive, not nan.")
	node.send_rate = NAN
	expect_error("MotorSynchronizer: mode 3 is none of LINEAR (0), SCREW (1), SEPARATE (2).")
	node.set(&"mode", 3)
	expect_error("MotorSynchronizer: channel is 0 to 255, not 256.")
	node.channel = 256
	expect_error("MotorSynchronizer: least_delay is in seconds and not negative, not %f." % -0.5)
	node.least_delay = -0.5
	expect_error("MotorSynchronizer: jitter_allowance is in seconds and not negative, not nan.")
	node.jitter_allowance = NAN
	expect_near(node.position_tolerance, 0.005, 1e-9)
	expect_near(node.max_latency, 0.2, 1e-9)
	expect_equal(node.channel, 0)
	expect_error("MotorSynchronizer.add_target: the node is null.")
	node.add_target(null)
	expect_error("MotorSynchronizer.remove_target: the node is null.")
	node.remove_target(null)


func test_settings_apply_immediately() -> void:
	await connect_peers(1, 2)
	await expect_motion(0.2, [branches[1]])
	for branch in branches:
		branch.synchronizer.position_tolerance = 0.001
		branch.synchronizer.mode = MultivectorLerp.SCREW
		branch.synchronizer.max_latency = 0.15
		branch.synchronizer.jitter_allowance = 0.3
	await expect_motion(0.3, [branches[1]])
	branches[1].synchronizer.least_delay = 0.35
	await move(branches[0], 0.8)
	var delay: float = branches[1].synchronizer.get_statistics()["playback_delay"]
	expect_true(delay >= 0.25, "the playback delay of %.2f s is at least 0.25 s" % delay)


func test_another_tick_rate() -> void:
	await connect_peers(1, 2)
	await expect_motion(0.2, [branches[1]])
	Engine.physics_ticks_per_second = 30
	await move(branches[0], 0.4)
	await expect_motion(0.3, [branches[1]])
	Engine.physics_ticks_per_second = 60


func test_warnings() -> void:
	var scene := Node3D.new()
	add_node(scene)
	var node := MotorSynchronizer.new()
	scene.add_child(node)
	_expect_warnings(
		node,
		[
			(
				'Nothing is replicated: assign "targets", name a "target_group", or call '
				+ "add_target() from a script."
			)
		]
	)
	node.targets = [^"../Nobody", ^".."]
	_expect_warnings(node, ['targets[0] ("../Nobody") does not lead to a Node3D.'])
	node.targets = []
	node.target_group = &"empty"
	_expect_warnings(
		node,
		[
			(
				'No Node3D of this scene is in the group "empty". That is right only if all of '
				+ "them are spawned later."
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
				+ "freeze_mode Kinematic, and unfreeze it where is_multiplayer_authority() holds."
			)
		]
	)
	body.freeze = true
	_expect_warnings(node, [])
	var other := MotorSynchronizer.new()
	other.name = "Other"
	other.targets = [^"../Crate"]
	scene.add_child(other)
	_expect_warnings(node, ["Crate is a target of Other too; one of the two is enough."])
	other.free()
	var synchronizer := MultiplayerSynchronizer.new()
	synchronizer.name = "Sync"
	synchronizer.replication_config = SceneReplicationConfig.new()
	synchronizer.replication_config.add_property(^"Crate:visible")
	scene.add_child(synchronizer)
	_expect_warnings(node, [])
	synchronizer.replication_config.add_property(^"Crate:position:y")
	_expect_warnings(
		node,
		[
			(
				"position of Crate is replicated by the MultiplayerSynchronizer Sync too; "
				+ "remove it there."
			)
		]
	)


func test_two_synchronizers_in_one_branch() -> void:
	await connect_peers(1, 2)
	for branch in branches:
		var second := MotorSynchronizer.new()
		second.name = "Second"
		branch.add_body("Other9").remove_from_group(&"bodies")
		second.targets = [^"../Other9"]
		branch.world.add_child(second)
	await expect_motion(0.2, [branches[1]])
	var sent: Node3D = branches[0].world.get_node("Other9")
	sent.position = Vector3(1, 2, 3)
	await tree.create_timer(SETTLE).timeout
	var shown: Node3D = branches[1].world.get_node("Other9")
	expect_vector_near(
		shown.position, sent.position, 0.005, "position replicated by the second synchronizer"
	)
	for branch in branches:
		expect_equal(branch.rejections, [] as Array[Array], "rejections")


func test_transforms_that_are_not_poses() -> void:
	await connect_peers(1, 2)
	await move(branches[0], SETTLE)
	var body := branches[0].get_body(0)
	var path := String(body.get_path())
	var node := String(branches[0].synchronizer.get_path())
	var valid := body.transform
	await tree.physics_frame
	expect_error(
		(
			(
				"MotorSynchronizer %s: the transform of %s has a value that is not finite (NaN "
				+ "or infinity); check where it was computed. What others see of it stays as it "
				+ "was."
			)
			% [node, path]
		)
	)
	body.transform = Transform3D(Basis.IDENTITY, Vector3(NAN, 0, 0))
	await tree.create_timer(SETTLE).timeout
	expect_vector_near(
		branches[1].get_body(0).position, valid.origin, 0.006, "position on other peers"
	)
	body.transform = valid
	await tree.create_timer(0.1).timeout
	expect_error(
		(
			(
				"MotorSynchronizer %s: the transform of %s is mirrored (negative scale), which "
				+ "a motor cannot represent; mirror a child node instead. What others see of it "
				+ "stays as it was."
			)
			% [node, path]
		)
	)
	body.scale = Vector3(-1, 1, 1)
	await tree.create_timer(0.1).timeout
	body.transform = valid
	await tree.create_timer(0.1).timeout
	expect_error(
		(
			(
				"MotorSynchronizer %s: the transform of %s is farther out, or its scale is "
				+ "larger or smaller, than a stream can say. What others see of it stays as it "
				+ "was."
			)
			% [node, path]
		)
	)
	body.position = Vector3(1e30, 0, 0)
	await tree.create_timer(0.1).timeout
	body.transform = Transform3D.IDENTITY
	await tree.create_timer(SETTLE).timeout
	expect_vector_near(
		branches[1].get_body(0).position, Vector3.ZERO, 0.005, "position after the errors"
	)
	expect_warning(
		(
			(
				"MotorSynchronizer %s: %s is scaled differently along its axes, or sheared; "
				+ "others see the nearest uniform scale. Scale a child node instead."
			)
			% [node, path]
		)
	)
	body.scale = Vector3(1, 2, 3)
	await tree.create_timer(SETTLE).timeout
	expect_vector_near(branches[1].get_body(0).scale, Vector3.ONE * 2.0, 0.01, "scale")


func test_transform_is_relative_to_the_parent() -> void:
	await connect_peers(1, 1)
	branches[0].world.position = Vector3(50, 0, 0)
	branches[1].world.position = Vector3(0, 70, 0)
	await expect_motion(0.2, [branches[1]])
	expect_vector_near(
		branches[1].get_body(0).global_position, Vector3(0, 70, 0), 3.0, "global position"
	)


func _expect_warnings(node: MotorSynchronizer, expected: Array) -> void:
	expect_equal(Array(node.get_setup_warnings()), expected, "warnings")
