extends Node3D
## The camera, which orbits a point near the player's ball. Right drag rotates, the wheel zooms.

const ROTATION_SPEED := 0.006
const ZOOM_STEP := 1.1
const FOLLOW_SPEED := 2.5
## Weight of the ball's position in the point that the camera orbits; the rest is the center of the
## arena.
const FOLLOW_SHARE := 0.3
## Initial azimuth in radians.
const YAW := 0.5

var camera := Camera3D.new()
var yaw := YAW
var pitch := -0.52
var distance: float
## Position of the player's ball, or the center of the arena.
var target := Vector3.ZERO


func _init(half_extent: float) -> void:
	distance = half_extent * 2.2
	camera.fov = 42.0
	camera.far = 300.0
	add_child(camera)


func _ready() -> void:
	_place()


func _process(delta: float) -> void:
	var goal := target * FOLLOW_SHARE
	goal.y = 0.0
	position = position.lerp(goal, 1.0 - exp(-FOLLOW_SPEED * delta))
	_place()


func _unhandled_input(event: InputEvent) -> void:
	var motion := event as InputEventMouseMotion
	if motion != null and motion.button_mask & MOUSE_BUTTON_MASK_RIGHT:
		yaw -= motion.relative.x * ROTATION_SPEED
		pitch = clampf(pitch - motion.relative.y * ROTATION_SPEED, -1.4, -0.1)
	var button := event as InputEventMouseButton
	if button != null and button.pressed:
		if button.button_index == MOUSE_BUTTON_WHEEL_UP:
			distance = maxf(distance / ZOOM_STEP, 4.0)
		elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			distance = minf(distance * ZOOM_STEP, 80.0)


func _place() -> void:
	var rotation_basis := Basis(Vector3.UP, yaw) * Basis(Vector3.RIGHT, pitch)
	camera.transform = Transform3D(rotation_basis, rotation_basis * Vector3(0.0, 0.0, distance))
