extends "res://tests/framework/network_test.gd"
## MotorSynchronizer.priority over a line that carries less than the motion needs.

const NarrowPeer := preload("res://tests/framework/narrow_peer.gd")

const BODIES := 100
const BYTES_PER_SECOND := 2200.0
## Seconds until the line is known and errors have grown.
const ADAPT := 8.0
const MEASURE := 4.0

## The second synchronizer of each branch, with the target "Body500".
var _ranked: Array[MotorSynchronizer] = []


func test_priority_set_before_the_stream_begins() -> void:
	await _connect(3)
	await _expect_smaller_errors(ADAPT)


func test_priority_set_while_the_stream_runs() -> void:
	await _connect(0)
	var similar := func(ratio: float) -> bool: return ratio < 1.8
	await _expect_ratio(similar, ADAPT, "targets of priority 0 have similar errors")
	_ranked[0].priority = 3
	await _expect_smaller_errors(MEASURE)


func _connect(priority: int) -> void:
	var peer := ENetMultiplayerPeer.new()
	var port := NetworkBranch.find_free_port()
	peer.create_server(port)
	make_branch("Server").api.multiplayer_peer = NarrowPeer.new(peer, BYTES_PER_SECOND)
	make_branch("Client").join(port)
	for branch in branches:
		branch.add_bodies(BODIES)
		branch.add_body("Body500").remove_from_group(&"bodies")
		var ranked := MotorSynchronizer.new()
		ranked.name = "Ranked"
		ranked.targets = [^"../Body500"]
		ranked.max_latency = 0.1
		ranked.priority = priority
		_ranked.append(ranked)
		branch.world.add_child(ranked)
		branch.start()
	await wait_until(
		func() -> bool:
			return branches.all(func(branch: NetworkBranch) -> bool: return branch.is_joined()),
		"all peers are connected"
	)
	var client := branches[1].api.get_unique_id()
	expect_warning("MotorSynchronizer: the line to peer %d carries about ..." % client)


func _expect_smaller_errors(after: float) -> void:
	var smaller := func(ratio: float) -> bool: return ratio > 2.0
	await _expect_ratio(smaller, after, "the target of priority 3 has smaller errors")


## Measures once, but up to three times in an emulator, where the frames stop now and then.
func _expect_ratio(is_expected: Callable, after: float, what: String) -> void:
	var holds: bool = is_expected.call(await _error_ratio(after))
	var attempts := 3 if Emulation.is_active() else 1
	while not holds and attempts > 1:
		attempts -= 1
		holds = is_expected.call(await _error_ratio(0.0))
	expect_true(holds, what)


## The mean distance of the other bodies from their paths relative to that of Body500, in the
## [constant MEASURE] seconds that follow [param after].
func _error_ratio(after: float) -> float:
	await _move_all(after)
	var ranked := 0.0
	var others := 0.0
	var relaxation := 1.0
	for i in roundi(MEASURE * 10.0):
		await _move_all(0.1)
		ranked += distance_from_path(branches[1].get_body(500))
		for body in BODIES:
			others += distance_from_path(branches[1].get_body(body)) / BODIES
		var statistics: Dictionary = branches[0].synchronizer.get_statistics()
		relaxation = maxf(relaxation, statistics["relaxation"] as float)
	expect_true(
		relaxation >= 4.0, "the line makes errors grow: %s times the tolerances" % relaxation
	)
	expect_true(nearest_po2(int(relaxation)) == int(relaxation), "the factor is a power of two")
	return others / ranked


func _move_all(seconds: float) -> void:
	for tick in roundi(seconds * Engine.physics_ticks_per_second):
		await tree.physics_frame
		time += 1.0 / Engine.physics_ticks_per_second
		for body: Node3D in branches[0].world.get_children().filter(_is_body):
			body.transform = _fast_pose(body.name, time)
			var path: PackedVector3Array = _paths.get(String(body.name), PackedVector3Array())
			path.append(body.position)
			_paths[String(body.name)] = path.slice(-240)


func _is_body(node: Node) -> bool:
	return node is Node3D


## Bodies move alike, at different phases.
static func _fast_pose(body_name: StringName, seconds: float) -> Transform3D:
	var number := String(body_name).to_int()
	var angle := seconds * 4.0 + number
	var place := Vector3(sin(angle) + 0.3 * sin(3.7 * angle), number, cos(1.3 * angle))
	return Transform3D(Basis(Vector3(0.6, 0.0, 0.8), angle * 0.7), place)
