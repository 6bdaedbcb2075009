extends RefCounted
## Scripted motion that needs no player: a heavy ball that rolls in a figure eight and, in the scene
## "cubes", lifts in the floor that launch cubes. It depends only on the time of the scene, so
## that it is the same in each run.

const BALL_RADIUS := 1.0
## Angular rate of the ball along the figure eight, in radians per second.
const BALL_RATE := 0.55
## Seconds between two launches. The lifts alternate.
const LIFT_INTERVAL := 1.5
const LIFT_RADIUS := 2.4
const LIFT_SPEED := 6.0
const LIFT_RING := 5.2
const LIFT_COUNT := 5

var _extent: float
var _has_lifts: bool
var _next_lift := LIFT_INTERVAL
var _lift := 0


func _init(scene: String, half_extent: float) -> void:
	_extent = half_extent - 3.2
	_has_lifts = scene != "push"


## Pose of the ball at a time of the scene.
func get_ball_pose(seconds: float) -> Transform3D:
	var angle := seconds * BALL_RATE
	var at := Vector3(
		_extent * sin(angle + 0.9), BALL_RADIUS, _extent * 0.75 * sin(2.0 * angle + 2.6)
	)
	var roll := seconds * 4.0
	return Transform3D(Basis(Vector3(cos(angle), 0.0, sin(angle)).normalized(), roll), at)


## Center of a lift on the floor.
static func get_lift_position(index: int) -> Vector3:
	if index == 0:
		return Vector3.ZERO
	var angle := TAU * index / (LIFT_COUNT - 1) + 0.6
	return Vector3(cos(angle), 0.0, sin(angle)) * LIFT_RING


## When the next launch is due, launches the cubes on that lift.
func update(seconds: float, cubes: Array[RigidBody3D]) -> void:
	if not _has_lifts or seconds < _next_lift:
		return
	_next_lift += LIFT_INTERVAL
	_lift = (_lift + 2) % LIFT_COUNT
	var center := get_lift_position(_lift)
	for i: int in cubes.size():
		var cube := cubes[i]
		var offset := cube.position - center
		var distance := Vector2(offset.x, offset.z).length()
		if distance > LIFT_RADIUS or offset.y > 2.5:
			continue
		var strength := 1.0 - 0.5 * distance / LIFT_RADIUS
		cube.sleeping = false
		cube.linear_velocity += Vector3(-offset.z * 0.5, LIFT_SPEED * strength, offset.x * 0.5)
		cube.angular_velocity += Vector3(sin(i * 1.3), 0.4, cos(i * 1.7)) * 4.0
