extends RigidBody3D
## A player's ball on the server. Forces move it in the direction that the player chooses.

## Radius in meters by scene; in "push" large enough to drive through the field of cubes.
const RADII: Dictionary[String, float] = {"cubes": 0.6, "push": 1.1}
## Mass of a ball of radius 1 m, in kilograms; a cube has 1 kg.
const MASS := 55.0
## Maximum driving force, in newtons per kilogram.
const DRIVE_FORCE := 13.0
const TOP_SPEED := 7.5
const JUMP_SPEED := 6.0
## Minimum seconds between two kicks of a player, enforced by the server.
const KICK_INTERVAL := 0.1

## Direction to drive, x and z of the arena. Its length is at most 1.
var drive := Vector2.ZERO
var wants_jump := false

var _next_kick := 0.0


func _init(scene: String) -> void:
	var radius := RADII[scene]
	mass = MASS * radius ** 3
	angular_damp = 0.6
	linear_damp = 0.3
	can_sleep = false
	var shape := SphereShape3D.new()
	shape.radius = radius
	var collision := CollisionShape3D.new()
	collision.shape = shape
	add_child(collision)


func _physics_process(_delta: float) -> void:
	var target_velocity := Vector3(drive.x, 0.0, drive.y) * TOP_SPEED
	var velocity_error := target_velocity - Vector3(linear_velocity.x, 0.0, linear_velocity.z)
	if drive.length_squared() > 0.01:
		apply_central_force(
			(velocity_error / TOP_SPEED * 2.0).limit_length(1.0) * DRIVE_FORCE * mass
		)
	if wants_jump:
		wants_jump = false
		if absf(linear_velocity.y) < 0.6:
			apply_central_impulse(Vector3(0.0, JUMP_SPEED * mass, 0.0))


## Stops the horizontal motion.
func stop() -> void:
	drive = Vector2.ZERO
	wants_jump = false
	linear_velocity = Vector3(0.0, linear_velocity.y, 0.0)
	angular_velocity = Vector3.ZERO


## Returns whether the player may kick at this time, in seconds, and if so restarts the interval.
func take_kick(now: float) -> bool:
	if now < _next_kick:
		return false
	_next_kick = now + KICK_INTERVAL
	return true
