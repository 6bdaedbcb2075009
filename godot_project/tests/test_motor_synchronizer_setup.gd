extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: properties, and errors that name the node.

## A cast to 32 bits would make a valid value of it.
const WIDE := (1 << 32) + 1


func test_defaults() -> void:
	var node := MotorSynchronizer.new()
	add_node(node)
	expect_near(node.position_tolerance, 0.005, 1e-9, "position_tolerance")
	expect_near(node.rotation_tolerance, 1.4, 1e-9, "rotation_tolerance")
	expect_near(node.position_tolerance_2d, 0.5, 1e-9, "position_tolerance_2d")
	expect_near(node.max_latency, 0.1, 1e-9, "max_latency")
	expect_near(node.send_rate, 20.0, 1e-9, "send_rate")
	expect_equal(node.mode, MultivectorLerp.SEPARATE, "mode")
	expect_equal(node.target_group, &"", "target_group")
	expect_equal(node.targets, [] as Array[NodePath], "targets")
	expect_equal(node.channel, 0, "channel")
	expect_equal(node.priority, 0, "priority")
	expect_near(node.min_delay, 0.0, 1e-9, "min_delay")
	expect_near(node.jitter_allowance, 0.2, 1e-9, "jitter_allowance")
	expect_near(node.blend_time, 0.15, 1e-9, "blend_time")
	expect_true(node.hide_until_known, "hide_until_known is set")
	expect_true(not node.relay, "relay is not set")
	expect_equal(node.max_packet_size, 1100, "max_packet_size")
	expect_equal(node.latency_preset, MotorSynchronizer.LATENCY_BALANCED, "latency_preset")


func test_invalid_values_change_nothing() -> void:
	var node := MotorSynchronizer.new()
	add_node(node)
	expect_error("MotorSynchronizer: position_tolerance is 0, but must be 1e-06 to 1000000 meters.")
	node.position_tolerance = 0.0
	expect_error("MotorSynchronizer: rotation_tolerance is -1, but must be 0.01 to 30 degrees.")
	node.rotation_tolerance = -1.0
	expect_error("MotorSynchronizer: max_latency is inf, but must be 0.001 to 10 seconds.")
	node.max_latency = INF
	expect_error("MotorSynchronizer: send_rate is nan, but must be 0.01 to 10000 Hz.")
	node.send_rate = NAN
	for value: int in [3, -1, WIDE]:
		expect_error(
			(
				"MotorSynchronizer: mode is %d, but must be LINEAR (0), SCREW (1) or SEPARATE (2)."
				% value
			)
		)
		node.set(&"mode", value)
	expect_error("MotorSynchronizer: channel is 256, but must be 0 to 255.")
	node.channel = 256
	for value: int in [9, -1, WIDE]:
		expect_error("MotorSynchronizer: priority is %d, but must be 0 to 8." % value)
		node.priority = value
	expect_error("MotorSynchronizer: min_delay is -0.5, but must be 0 to 10 seconds.")
	node.min_delay = -0.5
	expect_error("MotorSynchronizer: jitter_allowance is nan, but must be 0 to 10 seconds.")
	node.jitter_allowance = NAN
	expect_error("MotorSynchronizer: blend_time is inf, but must be 0 to 10 seconds.")
	node.blend_time = INF
	expect_error(
		"MotorSynchronizer: position_tolerance_2d is -0.5, but must be 1e-06 to 1000000 pixels."
	)
	node.position_tolerance_2d = -0.5
	for size: int in [255, 65001]:
		expect_error(
			"MotorSynchronizer: max_packet_size is %d, but must be 256 to 65000 bytes." % size
		)
		node.max_packet_size = size
	for value: int in [4, -1, WIDE]:
		expect_error(
			(
				(
					"MotorSynchronizer: latency_preset is %d, but must be LATENCY_CUSTOM (0), "
					+ "LATENCY_RESPONSIVE (1), LATENCY_BALANCED (2) or LATENCY_ECONOMICAL (3)."
				)
				% value
			)
		)
		node.set(&"latency_preset", value)
	expect_near(node.position_tolerance, 0.005, 1e-9)
	expect_near(node.max_latency, 0.1, 1e-9)
	expect_equal(node.channel, 0)
	expect_equal(node.priority, 0)
	node.priority = 8
	expect_equal(node.priority, 8, "priority")
	expect_near(node.blend_time, 0.15, 1e-9)
	expect_near(node.position_tolerance_2d, 0.5, 1e-9)
	expect_equal(node.max_packet_size, 1100)
	expect_equal(node.latency_preset, MotorSynchronizer.LATENCY_BALANCED)
	var freed := Node3D.new()
	freed.free()
	for target: Variant in [null, freed]:
		for method: String in ["add_target", "remove_target", "teleport", "free_target"]:
			expect_error("MotorSynchronizer.%s: the node is null." % method)
			node.call(method, target)


func test_settings_apply_immediately() -> void:
	await connect_peers(1, 2)
	await expect_motion(0.2, [branches[1]])
	for branch in branches:
		branch.synchronizer.position_tolerance = 0.001
		branch.synchronizer.mode = MultivectorLerp.SCREW
		branch.synchronizer.max_latency = 0.15
		branch.synchronizer.jitter_allowance = 0.3
	await expect_motion(0.3, [branches[1]])
	branches[1].synchronizer.min_delay = 0.35
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


func test_latency_presets() -> void:
	var node := MotorSynchronizer.new()
	add_node(node)
	var presets := {
		MotorSynchronizer.LATENCY_RESPONSIVE: [0.05, 40.0],
		MotorSynchronizer.LATENCY_ECONOMICAL: [0.2, 10.0],
		MotorSynchronizer.LATENCY_BALANCED: [0.1, 20.0],
	}
	for preset: MotorSynchronizer.LatencyPreset in presets:
		node.latency_preset = preset
		expect_equal([node.max_latency, node.send_rate], presets[preset], "settings")
		expect_equal(node.latency_preset, preset, "latency_preset")
	node.max_latency = 0.07
	expect_equal(node.latency_preset, MotorSynchronizer.LATENCY_CUSTOM, "with another latency")
	node.latency_preset = MotorSynchronizer.LATENCY_CUSTOM
	expect_equal([node.max_latency, node.send_rate], [0.07, 20.0], "settings")
	node.max_latency = 0.05
	expect_equal(node.latency_preset, MotorSynchronizer.LATENCY_CUSTOM, "at another rate")
	node.send_rate = 40.0
	expect_equal(node.latency_preset, MotorSynchronizer.LATENCY_RESPONSIVE, "of both")
	# The inspector restores these when a change of the preset is undone.
	expect_equal(
		node.call(&"_get_linked_undo_properties", &"latency_preset", 2),
		PackedStringArray(["max_latency", "send_rate"]),
		"linked properties"
	)


func test_a_scene_stores_what_a_preset_sets_and_not_the_preset() -> void:
	var node := MotorSynchronizer.new()
	add_node(node)
	node.latency_preset = MotorSynchronizer.LATENCY_RESPONSIVE
	var scene := PackedScene.new()
	expect_equal(scene.pack(node), OK, "packing the scene")
	var stored := PackedStringArray()
	for i in scene.get_state().get_node_property_count(0):
		stored.append(scene.get_state().get_node_property_name(0, i))
	stored.sort()
	expect_equal(stored, PackedStringArray(["max_latency", "send_rate"]), "stored properties")
	var copy: MotorSynchronizer = scene.instantiate()
	expect_equal(copy.latency_preset, MotorSynchronizer.LATENCY_RESPONSIVE, "preset of the copy")
	copy.free()


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
				+ "or infinity); check where it was computed. Other peers keep seeing its last pose."
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
				+ "a motor cannot represent; mirror a child node instead. Other peers keep seeing "
				+ "its last pose."
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
				"MotorSynchronizer %s: the transform of %s is out of range: too far from the "
				+ "origin, or its scale is too small or too large. Other peers keep seeing its "
				+ "last pose."
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
				"MotorSynchronizer %s: the scale of %s is non-uniform or sheared. Other peers see "
				+ "the nearest uniform scale. Scale a child node instead."
			)
			% [node, path]
		)
	)
	body.scale = Vector3(1, 2, 3)
	await tree.create_timer(SETTLE).timeout
	expect_vector_near(branches[1].get_body(0).scale, Vector3.ONE * 2.0, 0.01, "scale")


func test_a_pose_out_of_range_is_reported_once() -> void:
	await connect_peers(1, 1)
	var body := branches[0].get_body(0)
	expect_error(
		(
			(
				"MotorSynchronizer %s: the transform of %s is out of range: too far from the "
				+ "origin, or its scale is too small or too large. Other peers keep seeing its "
				+ "last pose."
			)
			% [branches[0].synchronizer.get_path(), body.get_path()]
		)
	)
	# Before the stream has a pose of the body, and while it moves.
	body.position = Vector3(1e30, 0, 0)
	await tree.create_timer(SETTLE).timeout
	for i in 10:
		body.position.x *= 1.1
		await tree.physics_frame
	await expect_motion(0.2, [branches[1]])


func test_transform_is_relative_to_the_parent() -> void:
	await connect_peers(1, 1)
	branches[0].world.position = Vector3(50, 0, 0)
	branches[1].world.position = Vector3(0, 70, 0)
	await expect_motion(0.2, [branches[1]])
	expect_vector_near(
		branches[1].get_body(0).global_position, Vector3(0, 70, 0), 3.0, "global position"
	)
