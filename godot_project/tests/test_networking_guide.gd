extends "res://tests/framework/network_test.gd"
## The situations of docs/guides/networking.md: their scripts run, and other peers see what the
## guide promises.

const PAGE := "docs/guides/networking.md"
const SCRIPT := "(?ms)^```gdscript (\\w+\\.gd)\\n(.*?)^```$"
const ENEMY := "user://guide_enemy.tscn"
## Run by tests/newcomer/networking.py.
const QUICK_START := "main.gd"


func test_every_script_of_the_guide_is_run() -> void:
	var tests := FileAccess.get_file_as_string("res://tests/test_networking_guide.gd")
	var scripts := _scripts()
	expect_equal(scripts.size(), 10, "number of scripts")
	for file in scripts:
		expect_true(
			file == QUICK_START or tests.contains('"%s"' % file), "%s is run by a test" % file
		)


func test_spawning() -> void:
	var enemy := Node3D.new()
	enemy.add_to_group(&"bodies", true)
	var scene := PackedScene.new()
	scene.pack(enemy)
	expect_equal(ResourceSaver.save(scene, ENEMY), OK, "saving the enemy")
	enemy.free()
	await _connect_scenes(
		1,
		"spawning.gd",
		func(main: Node3D) -> void:
			var spawner := MultiplayerSpawner.new()
			spawner.name = "Spawner"
			spawner.spawn_path = ^".."
			spawner.add_spawnable_scene(ENEMY)
			main.add_child(spawner)
	)
	await move(branches[0], SETTLE)
	branches[0].world.call(&"spawn_enemy", 1, Vector3(5, 6, 7))
	var world := branches[1].world
	await wait_until(func() -> bool: return world.has_node(^"Enemy1"), "the enemy to be spawned")
	var shown: Node3D = world.get_node(^"Enemy1")
	# The signal process_frame precedes the node's first frame.
	for i in 60:
		await tree.process_frame
		if shown.visible:
			expect_vector_near(shown.position, Vector3(5, 6, 7), 0.006, "position of the enemy")
	expect_true(shown.visible, "the enemy is shown")


func test_projectiles_that_end() -> void:
	var ends: Array[Vector3] = []
	await _connect_scenes(
		2, "", func(main: Node3D) -> void: main.add_child(_make("projectile.gd", "Projectile"))
	)
	for branch in branches:
		var projectile: Node3D = branch.world.get_node(^"Projectile")
		projectile.connect(&"exploded", func() -> void: ends.append(projectile.position))
	await wait_until(func() -> bool: return ends.size() == 3, "three explosions")
	for end in ends:
		expect_vector_near(end, ends[0], 0.006, "place of the explosion")
	await wait_until(
		func() -> bool: return not branches[0].world.has_node(^"Projectile"),
		"the authority to free it"
	)


func test_grabbing_and_throwing() -> void:
	await _connect_scenes(
		2, "grabbing.gd", func(main: Node3D) -> void: main.add_child(_make("", "Body0"))
	)
	await expect_motion(0.2, [branches[1], branches[2]])
	for taker: NetworkBranch in [branches[1], branches[0]]:
		taker.world.call(&"take", taker.get_body(0))
		var watched := branches.filter(func(branch: NetworkBranch) -> bool: return branch != taker)
		await wait_until(
			func() -> bool:
				return branches.all(
					func(branch: NetworkBranch) -> bool:
						return (
							branch.get_body(0).get_multiplayer_authority()
							== taker.api.get_unique_id()
						)
				),
			"all peers to know the owner"
		)
		# A busy machine may delay a few frames.
		var beside := 0
		for tick in 60:
			await move(taker, 1.0 / 60.0)
			for branch: NetworkBranch in watched:
				var distance := distance_from_path(branch.get_body(0))
				beside += 1 if distance > 0.02 else 0
				expect_true(distance < 0.1, "the ball is near its path on %s" % branch.root.name)
		expect_true(beside <= 6, "in %d of 120 frames the ball is beside its path" % beside)


func test_vehicles() -> void:
	await _connect_scenes(
		1,
		"vehicles.gd",
		func(main: Node3D) -> void:
			main.add_child(_make("", "Vehicle"))
			main.add_child(_make("", "Passenger"))
	)
	var main: Node3D = branches[0].world
	var vehicle: Node3D = main.get_node(^"Vehicle")
	var passenger: Node3D = main.get_node(^"Passenger")
	var shown: Node3D = branches[1].world.get_node(^"Passenger")
	passenger.position.z = 1.0
	var before := NAN
	var largest := 0.0
	var smallest := 0.0
	for tick in 120:
		await tree.physics_frame
		vehicle.position.x += 2.0 / 60.0
		if passenger.get_parent() == main:
			passenger.position.x += 2.0 / 60.0
		if tick == 60:
			main.call(&"board", passenger, vehicle)
		if tick > 40:
			var x := shown.global_position.x
			if not is_nan(before):
				largest = maxf(largest, x - before)
				smallest = minf(smallest, x - before)
			before = x
	expect_equal(shown.get_parent().name, &"Vehicle", "parent on the client")
	expect_true(largest < 0.3, "a step of %.2f m is no jump" % largest)
	expect_true(smallest > -0.02, "a step of %.3f m is not backwards" % smallest)
	expect_near(shown.global_position.z, 1.0, 0.006, "z on the client")


func test_pausing() -> void:
	await _connect_scenes(
		1, "pausing.gd", func(main: Node3D) -> void: main.add_child(_make("", "Body0"))
	)
	await expect_motion(0.2, [branches[1]])
	branches[0].world.rpc(&"set_paused", true)
	expect_true(tree.paused, "the tree is paused")
	# The synchronizers still run.
	await expect_motion(0.2, [branches[1]])
	branches[0].world.rpc(&"set_paused", false)
	await expect_motion(0.2, [branches[1]])


## The server does not forward packets for Godot, so the motion can only come through the relay.
func test_many_owners() -> void:
	await _connect_scenes(
		2,
		"many_owners.gd",
		func(main: Node3D) -> void:
			for branch in branches:
				branch.api.server_relay = false
			for i in 3:
				main.add_child(_make("", "Body%d" % i))
	)
	for branch in branches:
		expect_true(branch.synchronizer.relay, "relay is set")
		for i in 3:
			branch.get_body(i).set_multiplayer_authority(branches[i].api.get_unique_id())
	for mover in branches:
		await move(mover, 2.0 * SETTLE)
		for branch in branches:
			var body := branch.get_body(branches.find(mover))
			expect_true(
				branch == mover or distance_from_path(body) < 0.01,
				"%s shows the body of %s" % [branch.root.name, mover.root.name]
			)


func test_small_packets() -> void:
	await _connect_scenes(
		1,
		"small_packets.gd",
		func(main: Node3D) -> void:
			for i in 150:
				main.add_child(_make("", "Body%d" % i))
	)
	expect_equal(branches[0].synchronizer.max_packet_size, 500, "max_packet_size")
	var sizes := PackedInt32Array()
	branches[1].api.peer_packet.connect(
		func(_peer: int, packet: PackedByteArray) -> void: sizes.append(packet.size())
	)
	var pose := func(_name: StringName, now: float) -> Transform3D: return default_pose(&"", now)
	await move(branches[0], 3.0 * SETTLE, pose)
	expect_true(
		distance_from_paths(branches[1]) < 0.008, "the bodies are on their paths on the client"
	)
	sizes.sort()
	expect_true(
		sizes.size() > 5 and sizes[-1] > 300 and sizes[-1] < 500,
		"the largest of %d packets has %d bytes" % [sizes.size(), sizes[-1]]
	)


func test_2d() -> void:
	await _connect_scenes(1, "", func(_main: Node3D) -> void: pass)
	var players: Array[Node2D] = []
	for branch in branches:
		var player: Node2D = _make("player_2d.gd", "Player")
		branch.root.add_child(player)
		players.append(player)
	await tree.create_timer(2.0 * SETTLE).timeout
	expect_true(players[1].position.x > 20.0, "the player moves to %s" % players[1].position)
	for i in 20:
		await tree.process_frame
		var error := players[1].position.x - 200.0 * players[1].rotation
		expect_true(
			absf(error) < 8.0 and absf(players[1].position.y) < 0.6,
			"the rotation fits to the position within %.2f px" % error
		)


func test_moving_in_process() -> void:
	await _connect_scenes(
		1, "", func(main: Node3D) -> void: main.add_child(_make("hand.gd", "Hand"))
	)
	await tree.create_timer(3.0 * SETTLE).timeout
	var shown: Node3D = branches[1].world.get_node(^"Hand")
	var offsets := PackedFloat32Array()
	for i in 60:
		await tree.process_frame
		offsets.append(shown.position.x - 2.0 * branches[1].synchronizer.get_media_time(1))
	offsets.sort()
	# The hand moves at 2 m/s of media time.
	expect_true(shown.position.x > 0.5, "the hand moves to %.2f m" % shown.position.x)
	expect_true(
		offsets[55] - offsets[5] < 0.02,
		"the hand deviates by %.0f mm" % ((offsets[55] - offsets[5]) * 1000.0)
	)


## Connects a server and clients with a script of the guide on the root of their scenes.
func _connect_scenes(clients: int, file: String, build: Callable) -> void:
	var port := 0
	for i in clients + 1:
		var branch := make_branch("Client%d" % i if i > 0 else "Server")
		var main: Node3D = _make(file, "Main")
		main.remove_from_group(&"bodies")
		branch.synchronizer.name = "MotorSynchronizer"
		branch.world.free()
		branch.world = main
		main.add_child(branch.synchronizer)
		build.call(main)
		branch.root.add_child(main)
		if i == 0:
			port = branch.host()
		else:
			branch.join(port)
	await wait_until(
		func() -> bool:
			return branches.all(
				func(branch: NetworkBranch) -> bool:
					return branch.is_joined() and branch.api.get_peers().size() >= 1
			),
		"all peers are connected"
	)


## A target with a script of the guide, or without one.
func _make(file: String, node_name: String) -> Node:
	var script: GDScript = null
	if not file.is_empty():
		script = GDScript.new()
		script.source_code = _scripts()[file].replace("res://enemy.tscn", ENEMY)
		expect_equal(script.reload(), OK, "compiling %s" % file)
	var is_2d := script != null and script.get_instance_base_type() == &"Node2D"
	var node: Node = Node2D.new() if is_2d else Node3D.new()
	node.set_script(script)
	node.name = node_name
	node.add_to_group(&"bodies")
	return node


## The text of each script by its file name.
func _scripts() -> Dictionary[String, String]:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var text := FileAccess.get_file_as_string(repository.path_join(PAGE))
	var scripts: Dictionary[String, String] = {}
	for found in RegEx.create_from_string(SCRIPT).search_all(text):
		scripts[found.get_string(1)] = found.get_string(2)
	return scripts
