extends "res://tests/framework/test_case.gd"
## The base of tests with several peers in one process: makes them, moves bodies on one, and tells how
## far from their paths the others show them.

const NetworkBranch := preload("res://tests/framework/network_branch.gd")

## Long enough for a stream to be asked for and shown.
const SETTLE := 0.3
## Ticks more where a busy machine does several of them in one frame, between which no packet comes.
const MORE_TICKS := 120
## Pictures a second in these tests, so that they do not take a whole core.
const FRAMES_PER_SECOND := 120

var branches: Array[NetworkBranch] = []
## Seconds that bodies have moved.
var time := 0.0

## Where each body of the moving peer was in the last ticks, by name.
var _paths: Dictionary[String, PackedVector3Array] = {}


## A peer that is the server, and its port.
func make_branch(branch_name: String) -> NetworkBranch:
	Engine.max_fps = FRAMES_PER_SECOND
	var branch := NetworkBranch.new(tree, branch_name)
	branches.append(branch)
	return branch


## A server and clients, each with the same bodies, connected.
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
		"all peers being connected"
	)


func wait_until(condition: Callable, what: String, limit := 4.0) -> bool:
	var deadline := Time.get_ticks_msec() + limit * 1000.0
	while not condition.call():
		if Time.get_ticks_msec() > deadline:
			fail("waited %.1f s in vain for %s" % [limit, what])
			return false
		await tree.process_frame
	expect_true(true, what)
	return true


## Moves the bodies of a branch for that long.
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


## A turning body on a circle of its own.
static func default_pose(body_name: StringName, seconds: float) -> Transform3D:
	var number := String(body_name).to_int()
	var angle := seconds * (1.0 + 0.1 * number)
	var place := Vector3(3.0 * number + cos(angle), sin(angle * 2.0) * 0.3, sin(angle))
	return Transform3D(Basis(Vector3(1.0, number, 0.5).normalized(), angle * 0.7), place)


## The largest distance in metres of a branch's bodies from the path of the last second.
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


## Moves the first branch's bodies while the others must show them on their paths.
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
	var travelled := 0.0
	var ticks := roundi(seconds * Engine.physics_ticks_per_second)
	for tick in ticks:
		var before := _positions(watched)
		await move(mover, 1.0 / Engine.physics_ticks_per_second)
		for branch in watched:
			worst = maxf(worst, distance_from_paths(branch))
		var after := _positions(watched)
		for i in mini(before.size(), after.size()):
			travelled += before[i].distance_to(after[i]) / before.size()
	expect_true(
		worst <= bound,
		"a distance of %.1f mm from the path, at most %.1f mm," % [worst * 1000.0, bound * 1000.0]
	)
	expect_true(travelled > 0.3 * seconds, "%.2f m that bodies travelled" % travelled)


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
