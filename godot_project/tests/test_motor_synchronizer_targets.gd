extends "res://tests/framework/network_test.gd"
## MotorSynchronizer: targets are added, removed, reparented and change their authority at run time.


func test_targets_by_path() -> void:
	await connect_peers(1, 2)
	for branch in branches:
		branch.synchronizer.target_group = &""
		branch.synchronizer.targets = [^"../Body1"]
	await expect_motion(0.3, [branches[1]])
	for branch in branches:
		expect_equal(
			branch.synchronizer.get_active_targets(),
			[branch.get_body(1)] as Array[Node3D],
			"targets"
		)
		expect_equal(branch.synchronizer.targets, [^"../Body1"] as Array[NodePath], "paths")


func test_targets_by_call() -> void:
	await connect_peers(1, 2)
	for branch in branches:
		branch.synchronizer.target_group = &""
	await wait_frames(10)
	for branch in branches:
		expect_equal(
			branch.synchronizer.get_active_targets(),
			[] as Array[Node3D],
			"targets without the group"
		)
		branch.changes.clear()
		branch.synchronizer.add_target(branch.get_body(0))
		branch.synchronizer.add_target(branch.get_body(0))
		expect_equal(branch.changes, PackedStringArray(["+Body0"]), "signals")
	await expect_motion(0.3, [branches[1]])
	branches[1].synchronizer.remove_target(branches[1].get_body(0))
	expect_equal(branches[1].changes, PackedStringArray(["+Body0", "-Body0"]), "signals")
	await _expect_no_motion(branches[1], 0)


func test_member_of_the_group_can_be_removed_and_added() -> void:
	await connect_peers(1, 2)
	await move(branches[0], SETTLE)
	var body := branches[0].get_body(1)
	branches[0].synchronizer.remove_target(body)
	await move(branches[0], 0.4)
	expect_equal(
		branches[0].synchronizer.get_active_targets(),
		[branches[0].get_body(0)] as Array[Node3D],
		"targets"
	)
	branches[0].synchronizer.add_target(body)
	await expect_motion(0.3, [branches[1]])


func test_members_join_and_leave_the_group() -> void:
	await connect_peers(1, 1)
	await move(branches[0], SETTLE)
	for branch in branches:
		branch.add_body("Body7")
		branch.changes.clear()
	await expect_motion(0.3, [branches[1]])
	for branch in branches:
		expect_equal(branch.changes, PackedStringArray(["+Body7"]), "signals")
		# One leaves and one joins in the same frame: their number stays the same.
		branch.get_body(7).remove_from_group(&"bodies")
		branch.add_body("Body8")
	await wait_until(
		func() -> bool:
			return branches.all(
				func(branch: NetworkBranch) -> bool: return branch.changes.size() == 3
			),
		"the change to be noticed"
	)
	for branch in branches:
		var changes := Array(branch.changes).slice(1)
		changes.sort()
		expect_equal(changes, ["+Body8", "-Body7"], "signals")
	await expect_motion(0.3, [branches[1]])


func test_freed_target_is_removed() -> void:
	await connect_peers(1, 3)
	await move(branches[0], SETTLE)
	branches[0].get_body(1).free()
	expect_equal(branches[0].changes[-1], "-Body1", "signals")
	await move(branches[0], SETTLE)
	branches[1].get_body(0).queue_free()
	await expect_motion(0.3, [branches[1]])
	expect_equal(branches[0].synchronizer.get_active_targets().size(), 2, "number of targets")
	await _expect_no_motion(branches[1], 1)


## As with a MultiplayerSpawner, which spawns on other peers after the authority.
func test_target_that_is_spawned_later_on_the_receiver() -> void:
	await connect_peers(1, 1)
	branches[0].add_body("Body4")
	await move(branches[0], SETTLE)
	var body := branches[1].add_body("Body4")
	await move(branches[0], 0.2)
	expect_true(distance_from_path(body) < 0.01, "the new body is shown immediately")
	await expect_motion(0.3, [branches[1]])


func test_with_a_multiplayer_spawner() -> void:
	await connect_peers(1, 0)
	var spawners: Array[MultiplayerSpawner] = []
	for branch in branches:
		var spawner := MultiplayerSpawner.new()
		spawner.name = "Spawner"
		spawner.spawn_function = func(number: int) -> Node:
			var body := Node3D.new()
			body.name = "Body%d" % number
			body.add_to_group(&"bodies")
			return body
		branch.world.add_child(spawner)
		spawner.spawn_path = ^".."
		spawners.append(spawner)
	for number in 3:
		spawners[0].spawn(number)
	await expect_motion(0.2, [branches[1]])
	expect_equal(branches[1].synchronizer.get_active_targets().size(), 3, "targets of the client")
	branches[0].get_body(1).free()
	await wait_until(
		func() -> bool: return branches[1].synchronizer.get_active_targets().size() == 2,
		"the client's node to be removed"
	)
	spawners[0].spawn(1)
	await expect_motion(0.2, [branches[1]])
	expect_equal(branches[1].synchronizer.get_active_targets().size(), 3, "targets of the client")


func test_target_is_reparented() -> void:
	await connect_peers(1, 2)
	await move(branches[0], SETTLE)
	for branch in branches:
		var raft := Node3D.new()
		raft.name = "Raft"
		branch.world.add_child(raft)
		raft.position = Vector3(100, 0, 0)
		branch.get_body(1).reparent(raft, false)
	await expect_motion(0.3, [branches[1]])
	var moved: Node3D = branches[1].world.get_node("Raft/Body1")
	expect_true(moved.global_position.x > 90.0, "the body moves with its parent")
	for branch in branches:
		# The path of a target includes its parents.
		branch.world.get_node("Raft").name = "Boat"
	await expect_motion(0.2, [branches[1]])
	# A new synchronizer knows only the new path.
	branches[1].world.remove_child(branches[1].synchronizer)
	branches[1].world.add_child(branches[1].synchronizer)
	await expect_motion(0.2, [branches[1]])
	var renamed: Node3D = branches[1].world.get_node("Boat/Body1")
	var place := renamed.position
	await move(branches[0], 0.2)
	expect_true(renamed.position.distance_to(place) > 0.02, "the body of the renamed parent moves")


## The paths of the two names have the same hash.
func test_rename_to_a_path_with_the_same_hash() -> void:
	await connect_peers(1, 0)
	for branch in branches:
		for title: String in ["Body1", "Bodymyzauyp"]:
			branch.add_body(title)
	await expect_motion(0.2, [branches[1]])
	for branch in branches:
		var world := branch.world.get_path()
		expect_error(
			(
				(
					"MotorSynchronizer %s: the paths of %s/Bodyayxxpyx and %s/Bodymyzauyp have the "
					+ "same hash, so peers cannot tell them apart. The first is not replicated; "
					+ "rename one of them on all peers."
				)
				% [branch.synchronizer.get_path(), world, world]
			)
		)
		branch.world.get_node("Body1").name = "Bodyayxxpyx"
	await expect_motion(0.2, [branches[1]])
	for branch in branches:
		expect_equal(branch.synchronizer.get_active_targets().size(), 1, "number of targets")


func test_each_peer_moves_its_own_body() -> void:
	await connect_peers(2, 3)
	await wait_until(
		func() -> bool:
			return (
				branches[1].api.get_peers().size() == 2 and branches[2].api.get_peers().size() == 2
			),
		"clients to know each other"
	)
	for branch in branches:
		for i in 3:
			branch.get_body(i).set_multiplayer_authority(branches[i].api.get_unique_id())
	for mover in branches:
		for branch in branches:
			branch.changes.clear()
		await move(mover, SETTLE)
		for tick in 15:
			await move(mover, 1.0 / 60.0)
			for watched in branches:
				if watched != mover:
					expect_true(
						distance_from_path(watched.get_body(branches.find(mover))) < 0.008,
						"%s shows the body of %s on its path" % [watched.root.name, mover.root.name]
					)
		expect_true(mover.get_body(branches.find(mover)).position != Vector3.ZERO, "the body moves")
	for branch in branches:
		expect_equal(branch.rejections, [] as Array[Array], "rejections")


func test_authority_changes() -> void:
	await connect_peers(2, 2)
	var client: int = branches[1].api.get_unique_id()
	await expect_motion(0.3, [branches[1], branches[2]])
	for branch in branches:
		branch.get_body(0).set_multiplayer_authority(client)
	await move(branches[1], SETTLE)
	for tick in 20:
		await move(branches[1], 1.0 / 60.0)
		for watched: NetworkBranch in [branches[0], branches[2]]:
			expect_true(
				distance_from_path(watched.get_body(0)) < 0.008,
				"%s follows the new authority" % watched.root.name
			)
	# The server is still the authority of Body1.
	await move(branches[0], SETTLE)
	expect_true(
		distance_from_path(branches[2].get_body(1)) < 0.008, "the other body follows the server"
	)
	for branch in branches:
		branch.get_body(0).set_multiplayer_authority(1)
	await expect_motion(0.3, [branches[1], branches[2]])
	for branch in branches:
		expect_equal(branch.rejections, [] as Array[Array], "rejections")


func test_only_the_authority_teleports() -> void:
	await connect_peers(1, 1)
	await move(branches[0], 0.1)
	expect_error(
		"MotorSynchronizer.teleport: only the authority of Body0, peer 1, can teleport it."
	)
	branches[1].synchronizer.teleport(branches[1].get_body(0))
	expect_error("MotorSynchronizer.teleport: World is not a target of Motors.")
	branches[0].synchronizer.teleport(branches[0].world)
	expect_error("MotorSynchronizer.teleport: the node is null.")
	branches[0].synchronizer.teleport(null)


func test_engine_interpolation_is_turned_off() -> void:
	tree.physics_interpolation = true
	await connect_peers(1, 1)
	await move(branches[0], SETTLE)
	var body := branches[1].get_body(0)
	expect_equal(
		body.physics_interpolation_mode,
		Node.PHYSICS_INTERPOLATION_MODE_OFF,
		"mode of a replicated body"
	)
	expect_equal(
		branches[0].get_body(0).physics_interpolation_mode,
		Node.PHYSICS_INTERPOLATION_MODE_INHERIT,
		"mode of the authority's body"
	)
	branches[1].synchronizer.remove_target(body)
	expect_equal(
		body.physics_interpolation_mode,
		Node.PHYSICS_INTERPOLATION_MODE_INHERIT,
		"mode of a removed target"
	)
	branches[1].synchronizer.add_target(body)
	await move(branches[0], SETTLE)
	expect_equal(
		body.physics_interpolation_mode,
		Node.PHYSICS_INTERPOLATION_MODE_OFF,
		"mode of a target that was added again"
	)
	branches[1].leave()
	await wait_frames(3)
	expect_equal(
		body.physics_interpolation_mode,
		Node.PHYSICS_INTERPOLATION_MODE_INHERIT,
		"mode without a server"
	)
	tree.physics_interpolation = false


func _expect_no_motion(branch: NetworkBranch, index: int) -> void:
	var place := branch.get_body(index).position
	await move(branches[0], 0.3)
	expect_equal(
		branch.get_body(index).position,
		place,
		"position of body %d of %s" % [index, branch.root.name]
	)
