extends Node3D
## The world of the server: cubes, arena and balls as physics bodies. It is independent of the
## replication.

const Layout := preload("layout.gd")
const PlayerBall := preload("player_ball.gd")
const Scenario := preload("scenario.gd")

## Number of slots for balls; slot 0 is the scripted ball.
const SLOTS := 8
const WALL_HEIGHT := 12.0
const KICK_IMPULSE := 5.0

var layout: Layout
## Time of the scene in seconds, advanced by physics ticks.
var seconds := 0.0
## If true, players, ball and lifts stop, so that all bodies come to rest.
var is_calm := false

var _scene: String
var _cubes: Array[RigidBody3D] = []
var _balls: Array[PhysicsBody3D] = []
var _scenario: Scenario


func _init(scene: String, cube_count: int, scripted_motion: bool) -> void:
	_scene = scene
	layout = Layout.new(scene, cube_count)
	_balls.resize(SLOTS)
	_add_arena()
	var shape := BoxShape3D.new()
	shape.size = Vector3.ONE * Layout.EDGE
	for pose: Transform3D in layout.poses:
		_add_cube(pose, shape)
	if scripted_motion:
		_scenario = Scenario.new(scene, layout.half_extent)
		_add_scripted_ball()


## Advances the scene before the physics step.
func step(delta: float) -> void:
	seconds += delta
	if _scenario != null and not is_calm:
		_balls[0].transform = _scenario.get_ball_pose(seconds)
		_scenario.update(seconds, _cubes)
	for i: int in _cubes.size():
		_keep_inside(_cubes[i], layout.poses[i].origin)
	for slot: int in range(1, SLOTS):
		var ball: RigidBody3D = _balls[slot]
		if ball != null:
			if is_calm:
				get_ball(slot).stop()
			_keep_inside(ball, get_spawn_position(slot))


func get_cube_count() -> int:
	return _cubes.size()


## IDs of the existing bodies: the cubes, then the slots of the balls.
func get_ids() -> PackedInt32Array:
	var ids := PackedInt32Array(range(_cubes.size()))
	for slot: int in SLOTS:
		if _balls[slot] != null:
			ids.append(_cubes.size() + slot)
	return ids


func get_pose(id: int) -> Transform3D:
	return _cubes[id].transform if id < _cubes.size() else _balls[id - _cubes.size()].transform


## Adds a player's ball and returns its slot, or 0 if all slots are taken.
func add_player() -> int:
	for slot: int in range(1, SLOTS):
		if _balls[slot] == null:
			var ball := PlayerBall.new(_scene)
			ball.position = get_spawn_position(slot)
			add_child(ball)
			_balls[slot] = ball
			return slot
	return 0


func remove_player(slot: int) -> void:
	_balls[slot].queue_free()
	_balls[slot] = null


func get_ball(slot: int) -> PlayerBall:
	return _balls[slot] as PlayerBall


## Kicks a cube in a direction, whose length is ignored.
func kick(cube: int, direction: Vector3) -> void:
	var push := (direction.normalized() + Vector3(0.0, 0.6, 0.0)) * KICK_IMPULSE
	_cubes[cube].sleeping = false
	_cubes[cube].apply_impulse(push, Vector3(0.0, 0.1, 0.0))


## Position where a player's ball enters the arena.
func get_spawn_position(slot: int) -> Vector3:
	var angle := TAU * slot / SLOTS + 0.4
	return (
		Vector3(cos(angle), 0.0, sin(angle)) * (layout.half_extent - 1.5) + Vector3(0.0, 1.2, 0.0)
	)


func _add_cube(pose: Transform3D, shape: Shape3D) -> void:
	var cube := RigidBody3D.new()
	cube.transform = pose
	cube.mass = 1.0
	var collision := CollisionShape3D.new()
	collision.shape = shape
	cube.add_child(collision)
	add_child(cube)
	_cubes.append(cube)


func _add_scripted_ball() -> void:
	var ball := AnimatableBody3D.new()
	ball.sync_to_physics = false
	var shape := SphereShape3D.new()
	shape.radius = Scenario.BALL_RADIUS
	var collision := CollisionShape3D.new()
	collision.shape = shape
	ball.add_child(collision)
	ball.transform = _scenario.get_ball_pose(0.0)
	add_child(ball)
	_balls[0] = ball


func _add_arena() -> void:
	var arena := StaticBody3D.new()
	add_child(arena)
	var half := layout.half_extent
	_add_box(arena, Vector3(0.0, -0.5, 0.0), Vector3(2.0 * half + 2.0, 1.0, 2.0 * half + 2.0))
	for side: float in [-1.0, 1.0]:
		var at := side * (half + 0.5)
		_add_box(
			arena, Vector3(at, WALL_HEIGHT * 0.5, 0.0), Vector3(1.0, WALL_HEIGHT, 2.0 * half + 2.0)
		)
		_add_box(
			arena, Vector3(0.0, WALL_HEIGHT * 0.5, at), Vector3(2.0 * half + 2.0, WALL_HEIGHT, 1.0)
		)


func _add_box(parent: StaticBody3D, center: Vector3, size: Vector3) -> void:
	var shape := BoxShape3D.new()
	shape.size = size
	var collision := CollisionShape3D.new()
	collision.shape = shape
	collision.position = center
	parent.add_child(collision)


## If a body has left the arena, drops it from above its start position.
func _keep_inside(body: RigidBody3D, home: Vector3) -> void:
	if (
		body.position.y > -2.0
		and absf(body.position.x) < layout.half_extent + 3.0
		and absf(body.position.z) < layout.half_extent + 3.0
	):
		return
	body.position = home + Vector3(0.0, 6.0, 0.0)
	body.linear_velocity = Vector3.ZERO
	body.angular_velocity = Vector3.ZERO
