extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: how bodies begin, change their owner and end.

## Client frames until a node without a known pose must be hidden, or is seen not to be.
const SOME_FRAMES := 3


func test_a_node_is_hidden_until_its_pose_is_known() -> void:
	await connect_peers(1, 1)
	await move(branches[0], SETTLE)
	var body := branches[1].add_body("Body4")
	await wait_frames(SOME_FRAMES)
	expect_true(not body.visible, "the body without a pose is hidden")
	branches[0].add_body("Body4").position = Vector3(5, 6, 7)
	await wait_until(func() -> bool: return body.visible, "the body to be shown")
	expect_vector_near(body.position, Vector3(5, 6, 7), 0.006, "position when it is shown")
	# The pose of this one is known before its node exists.
	branches[0].add_body("Body5").position = Vector3(1, 2, 3)
	await tree.create_timer(SETTLE).timeout
	var known := branches[1].add_body("Body5")
	await wait_frames(2)
	expect_true(known.visible, "the body with a known pose is shown")
	expect_vector_near(known.position, Vector3(1, 2, 3), 0.006, "its position")


func test_a_node_without_a_pose_is_not_hidden_for_ever() -> void:
	await connect_peers(1, 1)
	await move(branches[0], SETTLE)
	var body := branches[1].add_body("Body4")
	body.position = Vector3(1, 0, 0)
	await wait_frames(SOME_FRAMES)
	expect_true(not body.visible, "the body is hidden")
	await wait_until(func() -> bool: return body.visible, "the body to be shown")
	expect_equal(body.position, Vector3(1, 0, 0), "its position")
	# What the game hides stays hidden.
	var hidden := branches[1].add_body("Body5")
	hidden.visible = false
	branches[0].add_body("Body5")
	await move(branches[0], SETTLE)
	expect_true(distance_from_path(hidden) < 0.01, "the hidden body moves")
	expect_true(not hidden.visible, "the hidden body is hidden")


func test_nodes_are_not_hidden_without_hide_until_known() -> void:
	await connect_peers(1, 1)
	branches[1].synchronizer.hide_until_known = false
	await move(branches[0], SETTLE)
	var body := branches[1].add_body("Body4")
	body.position = Vector3(1, 0, 0)
	for i in SOME_FRAMES:
		await wait_frames(1)
		expect_true(body.visible, "the body is shown")
	expect_equal(body.position, Vector3(1, 0, 0), "its position")
	branches[0].add_body("Body4")
	await move(branches[0], SETTLE)
	expect_true(distance_from_path(body) < 0.01, "the body moves")


func test_a_freed_target_is_shown_to_its_end() -> void:
	await connect_peers(2, 1)
	var ended: Array[Node] = []
	var ends := PackedVector3Array()
	for watched: NetworkBranch in [branches[1], branches[2]]:
		watched.synchronizer.target_ended.connect(
			func(node: Node3D) -> void:
				ended.append(node)
				ends.append(node.position)
		)
	var fly := func(_name: StringName, now: float) -> Transform3D:
		return Transform3D(Basis.IDENTITY, Vector3(40.0 * now, 0, 0))
	await move(branches[0], 2.0 * SETTLE, fly)
	var projectile := branches[0].get_body(0)
	var last := projectile.position
	await tree.physics_frame
	branches[0].synchronizer.free_target(projectile)
	expect_true(not projectile.visible, "the projectile is hidden at once")
	expect_equal(projectile.process_mode, Node.PROCESS_MODE_DISABLED, "process_mode")
	await wait_frames(2)
	expect_equal(branches[0].changes[-1], "-Body0", "signals of the authority")
	expect_equal(ended.size(), 0, "ends before playback has reached them")
	expect_true(branches[1].get_body(0).visible, "the projectile is still shown")
	await wait_until(func() -> bool: return ended.size() == 2, "the projectile to end")
	for i in ended.size():
		expect_vector_near(ends[i], last, 0.006, "place of the end")
		expect_true(not (ended[i] as Node3D).visible, "the projectile is hidden after its end")
	expect_true(
		is_instance_valid(projectile), "the authority frees it after other peers see the end"
	)
	var id := projectile.get_instance_id()
	await wait_until(
		func() -> bool: return not is_instance_id_valid(id), "the projectile to be freed"
	)
	await move(branches[0], 0.3)
	expect_equal(ended.size(), 2, "number of ends")
	for branch in branches:
		expect_equal(branch.rejections, [] as Array[Array], "rejections")


func test_a_removed_target_rests_at_its_last_pose() -> void:
	await connect_peers(1, 2)
	var ended := PackedStringArray()
	branches[1].synchronizer.target_ended.connect(func(node: Node) -> void: ended.append(node.name))
	await move(branches[0], SETTLE)
	await tree.physics_frame
	branches[0].synchronizer.remove_target(branches[0].get_body(1))
	var last := branches[0].get_body(1).position
	await move(branches[0], 2.0 * SETTLE)
	var shown := branches[1].get_body(1)
	# It is at most a frame short of its end.
	expect_vector_near(shown.position, last, 0.025, "position of the removed target")
	expect_true(shown.visible, "the removed target is shown")
	expect_equal(ended, PackedStringArray(), "ended targets")
	expect_true(distance_from_path(branches[1].get_body(0)) < 0.008, "the other one moves")


func test_only_the_authority_frees() -> void:
	await connect_peers(1, 1)
	await move(branches[0], 0.1)
	expect_error("MotorSynchronizer.free_target: only the authority of Body0, peer 1, can free it.")
	branches[1].synchronizer.free_target(branches[1].get_body(0))
	expect_error("MotorSynchronizer.free_target: World is not a target of Motors.")
	branches[0].synchronizer.free_target(branches[0].world)
	expect_error("MotorSynchronizer.free_target: the node is null.")
	branches[0].synchronizer.free_target(null)
	await expect_motion(0.2, [branches[1]])


## A new node of the same name does not fly the path of the old one.
func test_a_new_life_of_a_name_is_another_body() -> void:
	await connect_peers(1, 1)
	var fly := func(_name: StringName, now: float) -> Transform3D:
		return Transform3D(Basis.IDENTITY, Vector3(10.0 * now, 0, 0))
	await move(branches[0], 2.0 * SETTLE, fly)
	for branch in branches:
		branch.get_body(0).free()
		branch.add_body("Body0").position = Vector3(-20, 0, 0)
	for tick in 40:
		await tree.physics_frame
		var shown := branches[1].get_body(0)
		expect_true(
			not shown.visible or shown.position.distance_to(Vector3(-20, 0, 0)) < 0.006,
			"the new body at %s is where it was created" % shown.position
		)
	expect_true(branches[1].get_body(0).visible, "the new body is shown")


func test_difference_between_two_owners_is_blended() -> void:
	var steps := PackedFloat32Array()
	for blend_time: float in [0.0, 0.6]:
		await connect_peers(2, 1)
		var watched := branches[2].get_body(0)
		branches[2].synchronizer.blend_time = blend_time
		expect_near(branches[2].synchronizer.blend_time, blend_time, 1e-9, "blend_time")
		await tree.create_timer(2.0 * SETTLE).timeout
		for branch in branches:
			branch.get_body(0).set_multiplayer_authority(branches[1].api.get_unique_id())
		branches[1].get_body(0).position = Vector3(1, 0, 0)
		var largest := 0.0
		var before := watched.position.x
		var deadline := Time.get_ticks_msec() + 4000.0 * Emulation.get_slowness()
		while watched.position.x < 0.999 and Time.get_ticks_msec() < deadline:
			await tree.process_frame
			largest = maxf(largest, watched.position.x - before)
			before = watched.position.x
		expect_near(watched.position.x, 1.0, 0.006, "x of the new owner")
		steps.append(largest)
		free_nodes()
	expect_true(steps[0] > 0.9, "without a blend, a step of %.2f m is most of 1 m" % steps[0])
	expect_true(steps[1] < 0.5, "with a blend, a step of %.2f m is less than 0.5 m" % steps[1])


func test_nodes_in_2d() -> void:
	await connect_peers(1, 0)
	var bodies: Array[Node2D] = []
	for branch in branches:
		var body := Node2D.new()
		body.name = "Sprite"
		body.add_to_group(&"bodies")
		branch.root.add_child(body)
		bodies.append(body)
	var sent: Array[Vector2] = []
	var worst := 0.0
	for tick in 90:
		await tree.physics_frame
		var angle := tick / 30.0
		bodies[0].position = Vector2(300.0 * cos(angle), 200.0 * sin(angle))
		bodies[0].rotation = angle
		bodies[0].scale = Vector2(1.5, 1.5)
		sent.append(bodies[0].position)
		if tick > 60:
			var nearest := INF
			for i in sent.size() - 1:
				var on_path := Geometry2D.get_closest_point_to_segment(
					bodies[1].position, sent[i], sent[i + 1]
				)
				nearest = minf(nearest, on_path.distance_to(bodies[1].position))
			worst = maxf(worst, nearest)
	expect_true(worst < 0.7, "a distance of %.2f px from the path is below 0.7 px" % worst)
	bodies[0].position = Vector2(50, 60)
	bodies[0].rotation = 1.0
	await tree.create_timer(2.0 * SETTLE).timeout
	expect_true(
		bodies[1].position.distance_to(Vector2(50, 60)) < 0.6, "position %s" % bodies[1].position
	)
	expect_near(bodies[1].rotation, 1.0, 0.03, "rotation")
	expect_near(bodies[1].scale.x, 1.5, 0.05, "scale")
