extends "res://tests/framework/test_case.gd"
## The base class of tests with several peers in one process. It creates the peers, moves bodies on
## one peer and measures their deviation from their paths on the others.

const NetworkBranch := preload("res://tests/framework/network_branch.gd")

## Seconds for a stream to be requested and played back.
const SETTLE := 0.3
## Additional ticks for a busy machine that runs several ticks, without packets between, in a frame.
const MORE_TICKS := 120
## Limits these tests to a part of one core.
const FRAMES_PER_SECOND := 120

var branches: Array[NetworkBranch] = []
## Seconds that bodies have moved.
var time := 0.0

## The latest positions of each body on the moving peer, by name.
var _paths: Dictionary[String, PackedVector3Array] = {}


## Adds a peer.
func make_branch(branch_name: String) -> NetworkBranch:
	Engine.max_fps = FRAMES_PER_SECOND
	var branch := NetworkBranch.new(tree, branch_name)
	branches.append(branch)
	return branch


## Connects a server and clients that all have the same bodies.
func connect_peers(clients: int, bodies: int, websocket := false) -> void:
	var port := make_branch("Server").host(websocket)
	for i in clients:
		make_branch("Client%d" % i).join(port, websocket)
	for branch in branches:
		branch.add_bodies(bodies)
		branch.start()
	await wait_until(
		func() -> bool:
			return branches.all(func(branch: NetworkBranch) -> bool: return branch.is_joined()),
		"all peers are connected"
	)


func wait_until(condition: Callable, what: String, limit := 4.0) -> bool:
	limit *= Emulation.get_slowness()
	var deadline := Time.get_ticks_msec() + limit * 1000.0
	while not condition.call():
		if Time.get_ticks_msec() > deadline:
			fail("timed out after %.1f s waiting for %s" % [limit, what])
			return false
		await tree.process_frame
	expect_true(true, what)
	return true


## Moves the bodies of a branch for [param seconds].
func move(branch: NetworkBranch, seconds: float, pose := default_pose) -> void:
	var ticks := roundi(seconds * Engine.physics_ticks_per_second)
	for tick in ticks:
		await tree.physics_frame
		time += 1.0 / Engine.physics_ticks_per_second
		for body: Node3D in branch.synchronizer.get_active_targets():
			if body.get_multiplayer_authority() == branch.api.get_unique_id():
				body.transform = pose.call(body.name, time)
				var path: PackedVector3Array = _paths.get_or_add(
					String(body.name), PackedVector3Array()
				)
				path.append(body.position)
				_paths[String(body.name)] = path.slice(-60)


## The pose of a body that moves on its own closed curve and rotates.
static func default_pose(body_name: StringName, seconds: float) -> Transform3D:
	var number := String(body_name).to_int()
	var angle := seconds * (1.0 + 0.1 * number)
	var place := Vector3(3.0 * number + cos(angle), sin(angle * 2.0) * 0.3, sin(angle))
	return Transform3D(Basis(Vector3(1.0, number, 0.5).normalized(), angle * 0.7), place)


## The largest distance in meters of a branch's bodies from their paths of the last second.
func distance_from_paths(branch: NetworkBranch) -> float:
	var worst := 0.0
	for body: Node3D in branch.synchronizer.get_active_targets():
		worst = maxf(worst, distance_from_path(body))
	return worst


func distance_from_path(body: Node3D) -> float:
	var path: PackedVector3Array = _paths.get(String(body.name), PackedVector3Array())
	var nearest := INF
	for i in path.size() - 1:
		nearest = minf(
			nearest,
			(
				Geometry3D
				. get_closest_point_to_segment(body.position, path[i], path[i + 1])
				. distance_to(body.position)
			)
		)
	return nearest


## Moves the bodies of [param mover] and expects them on their paths in the watched branches.
func expect_motion(
	seconds: float, watched: Array[NetworkBranch], mover: NetworkBranch = branches[0]
) -> void:
	var bound := 1.2 * mover.synchronizer.position_tolerance + 0.001
	await move(mover, SETTLE)
	for tick in MORE_TICKS:
		if watched.all(
			func(branch: NetworkBranch) -> bool: return distance_from_paths(branch) <= bound
		):
			break
		await move(mover, 1.0 / Engine.physics_ticks_per_second)
	var worst := 0.0
	var traveled := 0.0
	var ticks := roundi(seconds * Engine.physics_ticks_per_second)
	for tick in ticks:
		var before := _positions(watched)
		await move(mover, 1.0 / Engine.physics_ticks_per_second)
		for branch in watched:
			worst = maxf(worst, distance_from_paths(branch))
		var after := _positions(watched)
		for i in mini(before.size(), after.size()):
			traveled += before[i].distance_to(after[i]) / before.size()
	expect_true(
		worst <= bound,
		"a distance of %.1f mm from the path, limit %.1f mm" % [worst * 1000.0, bound * 1000.0]
	)
	expect_true(traveled > 0.3 * seconds, "%.2f m traveled by the bodies" % traveled)


func free_nodes() -> void:
	for branch in branches:
		branch.free_all()
	branches.clear()
	Engine.max_fps = 0
	super()


func _positions(watched: Array[NetworkBranch]) -> PackedVector3Array:
	var positions := PackedVector3Array()
	for branch in watched:
		for body: Node3D in branch.synchronizer.get_active_targets():
			positions.append(body.position)
	return positions
